"""Reports for readers: figures, charts, the page, LaTeX and Markdown."""
