# Input filter of doc/Doxyfile. In rift a docstring holds for all declarations of
# data and types that follow it up to the next empty line; Doxygen takes it for
# the first one alone. The filter repeats it before each of the others, in the
# same line, so that the numbers of lines stay.
#
# usage: awk -f doxygen_header.awk HEADER

# Splits `text` at commas outside of all brackets into parts[1..n]; returns n.
function split_declarators(text, parts,    i, c, depth, n) {
  n = 1
  parts[1] = ""
  for (i = 1; i <= length(text); ++i) {
    c = substr(text, i, 1)
    if (c ~ /[<(\[{]/)
      ++depth
    if (c ~ /[>)\]}]/)
      --depth
    if (c == "," && depth == 0)
      parts[++n] = ""
    else
      parts[n] = parts[n] c
  }
  return n
}

# `T a, b;` as `T a; /** docstring */ T b;`.
function single_declarations(line,    parts, n, type, i) {
  sub(/;$/, "", line)
  n = split_declarators(line, parts)
  if (n == 1)
    return line ";"
  type = parts[1]
  # The name of the first: the last word before its extent and its value.
  sub(/ *[*&]*[A-Za-z_0-9]+ *(\[.*|=.*|\{.*)?$/, "", type)
  line = parts[1] ";"
  for (i = 2; i <= n; ++i)
    line = line " " docstring " " type parts[i] ";"
  return line
}

# With a backslash, the dot of an abbreviation does not end the brief description.
BEGIN { split("eq,eqs,Fig, St, al", abbreviations, ",") }

/^ *\/\*\*/ { docstring = "/**"; in_docstring = 1; is_first = 1 }

in_docstring {
  for (i in abbreviations)
    gsub(abbreviations[i] "\\.( |$)", abbreviations[i] ".\\ ")
}

{ text = $0; sub(/^ +/, "", text) }

in_docstring {
  print
  in_docstring = text !~ /\*\/$/
  sub(/^\/?\*+ ?/, "", text)
  docstring = docstring (text == "/" ? " */" : " " text)
  next
}

in_declaration { print; in_declaration = text !~ /;$/; next }

text ~ /^[A-Za-z_].*[;=]$/ && text !~ /\)( const)?;$/ &&
text !~ /^(class|struct|enum|template|friend|return) / {
  if (docstring != "") {
    if (text ~ /;$/)
      text = single_declarations(text)
    else
      in_declaration = 1
    print (is_first ? "" : docstring " ") text
    is_first = 0
    next
  }
}

{ docstring = ""; print }
