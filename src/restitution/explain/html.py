def to_html(e): return ""
def to_fragment(e): return ""
