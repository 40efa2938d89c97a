//! From tokens to code, by recursive descent.
//!
//! | rule | is |
//! |---|---|
//! | sum | product, then any number of + or − and a product |
//! | product | sign, then any number of * or / and a sign |
//! | sign | − or + before a sign, or a power |
//! | power | atom, or atom ^ sign |
//! | atom | number, name, function(sum, …), (sum) |
//!
//! So −x^2 = −(x^2), 2^3^2 = 2^(3^2), and 2^-1 is allowed.

use super::code::Op;
use super::function::{Callable, FUNCTIONS};
use super::graph::constant;
use super::names::Names;
use super::token::{Placed, Token, tokens};
use super::{ExpressionError, LARGEST_DEPTH, LARGEST_LENGTH};

/// The code of a formula.
pub fn parse(text: &str, names: &Names) -> Result<Vec<Op>, ExpressionError> {
    if text.len() > LARGEST_LENGTH {
        let reason = format!(
            "a formula of {} bytes; {LARGEST_LENGTH} are allowed",
            text.len()
        );
        return Err(ExpressionError::new(1, reason));
    }
    let mut parser = Parser {
        tokens: tokens(text)?,
        at: 0,
        depth: 0,
        code: Vec::new(),
        names,
    };
    parser.sum()?;
    match parser.peek() {
        Token::End => Ok(parser.code),
        Token::Sign(')') => parser.refuse("this bracket was never opened"),
        Token::Sign(_) => parser.refuse("an operator at the wrong place"),
        _ => parser.refuse("an operator is missing here: products are written with *"),
    }
}

struct Parser<'a> {
    tokens: Vec<Placed>,
    at: usize,
    depth: usize,
    code: Vec<Op>,
    names: &'a Names,
}

type Parsed = Result<(), ExpressionError>;

impl Parser<'_> {
    fn peek(&self) -> &Token {
        &self.tokens[self.at].0
    }

    fn column(&self) -> usize {
        self.tokens[self.at].1
    }

    fn refuse<T>(&self, reason: &str) -> Result<T, ExpressionError> {
        Err(ExpressionError::new(self.column(), reason))
    }

    /// The next token, unless it is the end, which stays.
    fn advance(&mut self) {
        self.at = (self.at + 1).min(self.tokens.len() - 1);
    }

    fn take(&mut self, sign: char) -> bool {
        let found = *self.peek() == Token::Sign(sign);
        if found {
            self.advance();
        }
        found
    }

    /// One level deeper: a formula must not exhaust the stack.
    fn deeper(&mut self, rule: impl FnOnce(&mut Self) -> Parsed) -> Parsed {
        if self.depth == LARGEST_DEPTH {
            return self.refuse(&format!("nested more than {LARGEST_DEPTH} levels deep"));
        }
        self.depth += 1;
        let parsed = rule(self);
        self.depth -= 1;
        parsed
    }

    fn sum(&mut self) -> Parsed {
        self.chain([('+', Op::Add), ('-', Op::Subtract)], Self::product)
    }

    fn product(&mut self) -> Parsed {
        self.chain([('*', Op::Multiply), ('/', Op::Divide)], Self::sign)
    }

    /// Operands joined from the left.
    fn chain(&mut self, signs: [(char, Op); 2], operand: fn(&mut Self) -> Parsed) -> Parsed {
        operand(self)?;
        while let Some((_, op)) = signs.into_iter().find(|(sign, _)| self.take(*sign)) {
            operand(self)?;
            self.code.push(op);
        }
        Ok(())
    }

    fn sign(&mut self) -> Parsed {
        if self.take('-') {
            self.deeper(Self::sign)?;
            self.code.push(Op::Negate);
            Ok(())
        } else if self.take('+') {
            self.deeper(Self::sign)
        } else {
            self.power()
        }
    }

    fn power(&mut self) -> Parsed {
        self.atom()?;
        if !self.take('^') {
            return Ok(());
        }
        let start = self.code.len();
        self.deeper(Self::sign)?;
        self.raise(start);
        Ok(())
    }

    /// To the power whose code begins at `start`.
    fn raise(&mut self, start: usize) {
        match whole_number(&self.code[start..]) {
            Some(n) => {
                self.code.truncate(start);
                self.code.push(Op::Integer(n));
            }
            None => self.code.push(Op::Power),
        }
    }

    fn atom(&mut self) -> Parsed {
        match self.peek().clone() {
            Token::Number(value) => {
                self.advance();
                self.code.push(Op::Constant(value));
                Ok(())
            }
            Token::Name(name) => self.name(&name),
            Token::Sign('(') => {
                self.advance();
                self.bracket()
            }
            Token::End => self.refuse("the formula ends where a value is expected"),
            Token::Sign(sign) => self.refuse(&format!("a value is expected here, not '{sign}'")),
        }
    }

    /// What follows an opening bracket.
    fn bracket(&mut self) -> Parsed {
        self.deeper(Self::sum)?;
        self.close()
    }

    fn close(&mut self) -> Parsed {
        match self.take(')') {
            true => Ok(()),
            false if *self.peek() == Token::Sign(',') => {
                self.refuse("a comma, where there is no function")
            }
            false => self.refuse("a closing bracket is missing"),
        }
    }

    fn name(&mut self, name: &str) -> Parsed {
        if let Some(op) = self.names.value(name) {
            self.advance();
            self.code.push(op);
            return Ok(());
        }
        let Some((_, callable)) = FUNCTIONS.iter().find(|f| f.0 == name) else {
            return self.refuse(&self.names.unknown(name));
        };
        self.advance();
        if !self.take('(') {
            let written = callable.written(name);
            return self.refuse(&format!("{name} is a function: write {written}"));
        }
        self.call(name, *callable)
    }

    /// The arguments of a function, and its code: that of two arguments stands behind the second and every further one.
    fn call(&mut self, name: &str, callable: Callable) -> Parsed {
        let mut count = 0;
        loop {
            let start = self.code.len();
            self.deeper(Self::sum)?;
            count += 1;
            match callable {
                Callable::One(function) if count == 1 => self.code.push(Op::Call(function)),
                Callable::Two(pair) | Callable::More(pair) if count > 1 => {
                    self.code.push(Op::Pair(pair));
                }
                Callable::Power if count == 2 => self.raise(start),
                _ => {}
            }
            let more = *self.peek() == Token::Sign(',');
            let fits = match self.peek() {
                Token::Sign(',') => count < *callable.arguments().end(),
                Token::Sign(')') => callable.arguments().contains(&count),
                _ => true,
            };
            if !fits {
                let written = callable.written(name);
                return self.refuse(&format!("the wrong number of arguments: write {written}"));
            }
            if !more {
                return self.close();
            }
            self.advance();
        }
    }
}

/// The value of a constant exponent, if it is a whole number of moderate size.
fn whole_number(code: &[Op]) -> Option<i32> {
    let value = constant(code)?;
    // Beyond, the power is 0, 1 or ∞ anyway.
    (value.fract() == 0.0 && value.abs() <= 1024.0).then_some(value as i32)
}
