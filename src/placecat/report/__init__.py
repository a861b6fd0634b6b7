"""Reports for readers: figures, charts, the HTML page, and tables in LaTeX and Markdown."""
