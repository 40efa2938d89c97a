//! Meshes, Regge functions and results written down as JSON and read again: the same bits, and nothing that is none.

use crate::common::{crooked_cube, random_regge};
use regge_curvature::functional::{
    action_gradient, action_hessian, angle_defects, distributional_curvature, regge_action,
};
use regge_curvature::{Mesh, ReggeFunction, ReggeSpace, Rules};
use serde::{Serialize, de::DeserializeOwned};
use serde_json::{Value, json};
use std::fmt::Debug;

/// What is written and read is the same, and so is what is written again: `==` alone takes 0 and −0 for one.
fn returns<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T) {
    let text = serde_json::to_string(value).expect("can be written");
    let read: T = serde_json::from_str(&text).expect("can be read");
    assert_eq!(*value, read);
    assert_eq!(text, serde_json::to_string(&read).expect("can be written"));
}

#[test]
fn meshes_return() {
    returns(&crooked_cube::<2>(3, 1));
    returns(&crooked_cube::<3>(2, 1));
    returns(&Mesh::<3>::torus(3).expect("a torus"));
    returns(&Mesh::<4>::simplex_boundary().expect("a sphere"));
    // The cells' order and the vertices' numbers stay, and with them all that is numbered.
    let mesh = Mesh::<2>::new_abstract(4, &[vec![3, 2, 1], vec![0, 2, 1]]).expect("two triangles");
    returns(&mesh);
}

#[test]
fn functions_return() {
    for degree in 0..=2 {
        let space = ReggeSpace::new(&crooked_cube::<3>(2, 1), degree);
        returns(&random_regge(&space, 0.1, 3));
        let space = ReggeSpace::new(&Mesh::<2>::torus(3).expect("a torus"), degree);
        returns(&random_regge(&space, 0.1, 4));
    }
}

#[test]
fn results_return() {
    let mesh = crooked_cube::<3>(2, 1);
    let g = random_regge(&ReggeSpace::new(&mesh, 0), 0.02, 3);
    let hats = regge_curvature::Lagrange::new(&mesh, 1);
    let rules = Rules::on(&mesh, 2);
    let sums = distributional_curvature(&g, &hats, &rules);
    returns(&sums);
    returns(&sums.of(13));
    returns(&regge_action(&g, &mesh, &rules));
    returns(&action_gradient(&g).expect("degree 0"));
    returns(&action_hessian(&g).expect("degree 0"));
    returns(&angle_defects(&g, &mesh, 2));
}

/// The document of two triangles with one thing changed is refused for the reason expected, in one line.
fn refused<T: DeserializeOwned + Debug>(good: &Value, path: &str, wrong: Value, reason: &str) {
    serde_json::from_value::<T>(good.clone()).expect("the document is right as it is");
    let mut document = good.clone();
    *document.pointer_mut(path).expect("a place in the document") = wrong;
    let error = serde_json::from_value::<T>(document).expect_err(reason);
    let error = error.to_string();
    assert!(error.contains(reason), "{error}");
    assert!(!error.contains('\n'), "{error}");
}

fn square() -> Value {
    json!({
        "version": 1,
        "dimension": 2,
        "vertices": [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]],
        "corners": null,
        "cells": [[0, 1, 2], [1, 2, 3]],
    })
}

#[test]
fn what_is_no_mesh_is_refused() {
    let no = |path, wrong, reason| refused::<Mesh<2>>(&square(), path, wrong, reason);
    no(
        "/version",
        json!(2),
        "version 2, and this library reads version 1",
    );
    no("/dimension", json!(3), "the mesh has dimension 3, not 2");
    no("/cells/1/2", json!(4), "cell 1: vertex 4 does not exist");
    no("/cells/1/2", json!(1), "cell 1: vertex 1 is repeated");
    no("/vertices/3", json!([0.1, 0.1]), "cell 1: inverted");
    no(
        "/vertices/3",
        json!([0.1]),
        "a point has 1 coordinates, not 2",
    );
    no("/corners", json!([]), "not both");
}

/// The version comes first, and is refused whatever else a later one may have.
#[test]
fn another_version_is_refused_before_its_contents() {
    let text = serde_json::to_string(&Mesh::<2>::single().expect("a triangle"));
    assert!(
        text.expect("can be written")
            .starts_with(r#"{"version":1,"#)
    );
    let later = r#"{"version": 2, "charts": [], "simplices": {}}"#;
    let error = serde_json::from_str::<Mesh<2>>(later).expect_err("a later version");
    assert_eq!(
        error.to_string(),
        "the document has version 2, and this library reads version 1 at line 1 column 13"
    );
}

/// Abstract meshes have as many vertices as their cells name, however large the number: it is not believed.
#[test]
fn a_vertex_too_many_costs_nothing() {
    let mut document = square();
    document["vertices"] = Value::Null;
    refused::<Mesh<2>>(
        &document,
        "/cells/1/2",
        json!(1u64 << 60),
        "is too large a number where the cells list 6 vertices",
    );
    refused::<Mesh<2>>(&document, "/cells", json!([]), "0 cells");
    refused::<Mesh<2>>(
        &document,
        "/cells/1/2",
        json!(4),
        "vertex 3: belongs to no cell",
    );
}

#[test]
fn what_is_no_function_is_refused() {
    let good = json!({
        "version": 1,
        "degree": 0,
        "mesh": square(),
        "coefficients": [1.0, 1.0, 2.0, 1.0, 1.0],
    });
    let no = |path, wrong, reason| refused::<ReggeFunction<f64, 2>>(&good, path, wrong, reason);
    no(
        "/version",
        json!(0),
        "version 0, and this library reads version 1",
    );
    no(
        "/mesh/version",
        json!(7),
        "version 7, and this library reads version 1",
    );
    no("/mesh/cells/0/0", json!(3), "vertex 0: belongs to no cell");
    no(
        "/degree",
        json!(1),
        "5 coefficients do not fit a Regge space of degree 1",
    );
    let huge = usize::MAX - 1;
    no("/degree", json!(huge), "5 coefficients do not fit");
    no("/coefficients", json!([1.0]), "1 coefficients do not fit");
    no("/coefficients/0", Value::Null, "invalid type: null");
}

/// Three lists for one number of test functions.
#[test]
fn sums_belong_to_the_same_functions() {
    let good = json!({"cells": [1.0], "faces": [2.0], "hinges": [3.0]});
    for (list, said) in [
        ("/faces", "for 1, 0 and 1 test functions"),
        ("/hinges", "for 1, 1 and 0 test functions"),
    ] {
        refused::<regge_curvature::functional::Sums<f64>>(&good, list, json!([]), said);
    }
}
