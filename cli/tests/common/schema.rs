//! As much of JSON Schema as docs/schema uses: a key that is not known here fails the test.

use serde_json::Value;

/// Where a value is not what a definition says, in words; the file's root is `root`.
pub fn faults(root: &Value, schema: &Value, value: &Value, at: &str) -> Vec<String> {
    let mut all = Vec::new();
    for (key, rule) in schema.as_object().expect("a schema is an object") {
        let further = match key.as_str() {
            "description" => vec![],
            "$ref" => {
                let name = rule.as_str().and_then(|r| r.strip_prefix("#/$defs/"));
                let schema = &root["$defs"][name.expect("a definition of the file")];
                faults(root, schema, value, at)
            }
            "anyOf" => any_of(root, rule, value, at),
            "const" | "enum" => listed(rule, value, at),
            "type" => typed(rule, value, at),
            "items" => {
                let list = value.as_array().into_iter().flatten().enumerate();
                list.flat_map(|(i, x)| faults(root, rule, x, &format!("{at}[{i}]")))
                    .collect()
            }
            "required" => {
                let names = rule.as_array().expect("a list").iter();
                let names = names.filter_map(Value::as_str);
                let missing = names.filter(|name| value.is_object() && value.get(name).is_none());
                missing
                    .map(|name| format!("{at}.{name} is missing"))
                    .collect()
            }
            "properties" => properties(root, schema, value, at),
            // With the properties.
            "additionalProperties" => vec![],
            unknown => vec![format!("{unknown} is not known to the test")],
        };
        all.extend(further);
    }
    all
}

fn properties(root: &Value, schema: &Value, value: &Value, at: &str) -> Vec<String> {
    let mut all = Vec::new();
    for (name, x) in value.as_object().into_iter().flatten() {
        let at = format!("{at}.{name}");
        match (
            schema["properties"].get(name),
            &schema["additionalProperties"],
        ) {
            (Some(rule), _) => all.extend(faults(root, rule, x, &at)),
            (None, Value::Bool(true)) => {}
            (None, Value::Bool(false)) => all.push(format!("{at} is not in the schema")),
            (None, rule) => all.extend(faults(root, rule, x, &at)),
        }
    }
    all
}

fn any_of(root: &Value, rules: &Value, value: &Value, at: &str) -> Vec<String> {
    let rules = rules.as_array().expect("a list").iter();
    let each: Vec<_> = rules.map(|rule| faults(root, rule, value, at)).collect();
    match each.iter().any(Vec::is_empty) {
        true => vec![],
        false => each.into_iter().min_by_key(Vec::len).expect("a rule"),
    }
}

fn listed(rule: &Value, value: &Value, at: &str) -> Vec<String> {
    let allowed = match rule {
        Value::Array(list) => list.contains(value),
        one => one == value,
    };
    if allowed {
        vec![]
    } else {
        vec![format!("{at} is {value}, not {rule}")]
    }
}

fn typed(rule: &Value, value: &Value, at: &str) -> Vec<String> {
    let is = |name: &str| match name {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        _ => false,
    };
    let fits = match rule {
        Value::Array(names) => names.iter().filter_map(Value::as_str).any(is),
        name => name.as_str().is_some_and(is),
    };
    if fits {
        vec![]
    } else {
        vec![format!("{at} is {value}, no {rule}")]
    }
}
