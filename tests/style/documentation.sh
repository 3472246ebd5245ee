#!/usr/bin/env bash
# Builds the pages of the documentation; any warning is an error. Ends with 77
# where Doxygen is not installed.
#
# usage: documentation.sh SOURCE FOLDER
set -euo pipefail
source=$1 folder=$2
command -v doxygen > /dev/null || {
  echo "Skipped: install the package doxygen." >&2
  exit 77
}
rm -rf "$folder"
mkdir -p "$folder"
"$source/scripts/documentation" "$folder"

# has PAGE TEXT: fails unless the page has the text.
has() {
  grep -qF -- "$2" "$folder/html/$1" || {
    echo "FAILED: $1 does not have: $2" >&2
    exit 1
  }
}
has index.html "rift simulates how rock breaks under fast loads"
has index.html 'href="md_doc_theory.html"'
# What the filters do: formulas, and docstrings of several declarations.
has md_doc_theory.html '\[E = \tfrac12'
[ "$(grep -cF 'mdescRight">Tensile strength and cohesion, Pa.' \
  "$folder/html/structrift_1_1FaceStrength.html")" = 2 ] || {
  echo "FAILED: a docstring does not hold for both of its declarations" >&2
  exit 1
}

# What has no docstring must be found.
cat > "$folder/undocumented.h" << 'END'
/** A class. */
class Class
{
public:
  void
  undocumented();
};
END
cd "$source"
! {
  cat doc/Doxyfile
  echo "INPUT = \"$folder/undocumented.h\""
  echo "OUTPUT_DIRECTORY = \"$folder/undocumented\""
} | doxygen - 2> "$folder/undocumented.log" &&
  grep -qF "Member undocumented() (function) of class Class is not documented" \
    "$folder/undocumented.log" || {
  echo "FAILED: a function without a docstring has not been reported:" >&2
  cat "$folder/undocumented.log" >&2
  exit 1
}
