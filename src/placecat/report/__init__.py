"""Reports for people: figures, charts, the page, LaTeX and Markdown."""
