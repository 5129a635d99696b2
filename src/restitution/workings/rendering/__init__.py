"""A worked solution for its readers: text, Markdown, LaTeX, HTML, Typst, and itself."""
