# Input filter of doc/Doxyfile: Markdown as GitHub shows it, for Doxygen. Formulas
# are lines $$...$$; links lead to pages, since Doxygen does not name headings as
# GitHub does.
#
# usage: awk -f doxygen_markdown.awk PAGE

/^\$\$.*\$\$/ {
  sub(/^\$\$/, "\\f[")
  sub(/\$\$/, "\\f]")
}

# The caption of a figure, with whatever it has in it.
/^\*[^* ].*[^*]\*$/ {
  sub(/^\*/, "<em>")
  sub(/\*$/, "</em>")
}

{
  # [text](page.md#heading), [text](#heading)
  gsub(/\.md#[^)]*\)/, ".md)")
  while (match($0, /\[[^\]]*\]\(#[^)]*\)/)) {
    link = substr($0, RSTART, RLENGTH)
    sub(/^\[/, "", link)
    sub(/\]\(.*/, "", link)
    $0 = substr($0, 1, RSTART - 1) link substr($0, RSTART + RLENGTH)
  }
  print
}
