//! From text to tokens, each with its column.

use super::ExpressionError;

/// What a formula is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    /// A number.
    Number(f64),
    /// A variable, a constant or a function.
    Name(String),
    /// One of + − * / ^ ( ) ,
    Sign(char),
    /// Nothing more.
    End,
}

/// A token and the column, from 1, where it begins.
pub type Placed = (Token, usize);

/// All tokens, the last of which is [`Token::End`].
pub fn tokens(text: &str) -> Result<Vec<Placed>, ExpressionError> {
    let chars: Vec<char> = text.chars().collect();
    let mut tokens = Vec::new();
    let mut at = 0;
    while at < chars.len() {
        let start = at;
        let token = match chars[at] {
            c if c.is_whitespace() => {
                at += 1;
                continue;
            }
            c if c.is_ascii_digit() || c == '.' => number(&chars, &mut at)?,
            c if c.is_alphabetic() || c == '_' => {
                at = end_of(&chars, at, |c| c.is_alphanumeric() || c == '_');
                Token::Name(chars[start..at].iter().collect())
            }
            '*' if chars.get(at + 1) == Some(&'*') => {
                return Err(ExpressionError::new(at + 1, "powers are written ^, not **"));
            }
            c if "+-*/^(),".contains(c) => {
                at += 1;
                Token::Sign(c)
            }
            c => {
                let reason = format!("the character {c:?} has no meaning in a formula");
                return Err(ExpressionError::new(at + 1, reason));
            }
        };
        tokens.push((token, start + 1));
    }
    tokens.push((Token::End, chars.len() + 1));
    Ok(tokens)
}

/// The first place from `at` on where `part` is false.
fn end_of(chars: &[char], at: usize, part: impl Fn(char) -> bool) -> usize {
    let rest = chars[at..].iter();
    at + rest.take_while(|c| part(**c)).count()
}

/// Digits, a point, digits, an exponent.
fn number(chars: &[char], at: &mut usize) -> Result<Token, ExpressionError> {
    let start = *at;
    let digit = |c: char| c.is_ascii_digit();
    *at = end_of(chars, *at, |c| digit(c) || c == '.');
    if matches!(chars.get(*at), Some('e' | 'E')) {
        let sign = usize::from(matches!(chars.get(*at + 1), Some('+' | '-')));
        let digits = *at + 1 + sign;
        // Without digits the e is not an exponent: the parser will ask for an operator before it.
        if chars.get(digits).copied().is_some_and(digit) {
            *at = end_of(chars, digits, digit);
        }
    }
    let text: String = chars[start..*at].iter().collect();
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(Token::Number(value)),
        Ok(_) => Err(ExpressionError::new(
            start + 1,
            format!("{text} is too large"),
        )),
        Err(_) => Err(ExpressionError::new(
            start + 1,
            format!("'{text}' is no number"),
        )),
    }
}
