"""What people read: figures, charts, the page, LaTeX and Markdown."""
