//! Tables in Markdown.

/// Text in a cell of a table: no bars.
pub fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}
