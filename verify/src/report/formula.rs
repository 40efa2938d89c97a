//! LaTeX to MathML.

use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

/// A displayed formula as MathML; the source itself where it cannot be read.
pub fn mathml(latex: &str) -> String {
    // A statement is wrapped in its source file; LaTeX does not mind.
    let latex: String = latex.split_whitespace().collect::<Vec<_>>().join(" ");
    let storage = Storage::new();
    let parser = Parser::new(&latex, &storage);
    let config = RenderConfig {
        display_mode: DisplayMode::Block,
        ..RenderConfig::default()
    };
    let mut text = String::new();
    match push_mathml(&mut text, parser, config) {
        Ok(()) => text,
        Err(_) => format!("<code>{}</code>", escape(&latex)),
    }
}

/// Text for HTML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
