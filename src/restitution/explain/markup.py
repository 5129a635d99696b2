def to_markdown(e): return ""
def to_latex(e, document=True): return ""
