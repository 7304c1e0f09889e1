# The conjuncts of a statement file, one per line: where it begins, how long it is, its definition, its text. Left out are
# those in a hypothesis, which a statement is weaker with, and on a side of <->, which is neither weaker nor stronger
# without one. Comments are blanked first.
{ text = text $0 "\n" }
function push(kind, at, len) { kinds[++count] = kind; begins[count] = at; ends[count] = at + len; depths[count] = depth }
# What follows token i, at its depth, once the operand that begins there is over.
function operand_end(i, d,   first, j) {
  first = kinds[i]
  for (j = i; j <= count; j++) {
    if (depths[j] < d || kinds[j] == "." && depths[j] == d) return j
    if (depths[j] == d && kinds[j] ~ /^(;|:=|\||end|with)$/) return j
    if (first !~ /^(forall|exists|let|fun|if|match)$/ && depths[j] == d && kinds[j] ~ /^(\/\\|\\\/|->|<->|then|else|in)$/) return j
  }
  return count
}
# + , - or 0 for <->: from token i on at depth d, then outwards.
function polarity(i, d,   sign, j, k) {
  sign = 1
  for (j = i; j <= count; j++) {
    if (kinds[j] == "." && depths[j] <= d) break
    if (depths[j] < d) { d = depths[j]; for (k = j - 1; k > 0 && !(depths[k] == d && kinds[k] == "("); k--); if (kinds[k - 1] == "~") sign = -sign; continue }
    if (depths[j] > d) continue
    if (kinds[j] == "<->") return 0
    if (kinds[j] == "->") { sign = -sign; j = skip(j + 1, d) - 1 }
    else if (kinds[j] ~ /^(\/\\|\\\/)$/ && kinds[j + 1] ~ /^(forall|exists|let|fun|if|match)$/) j = operand_end(j + 1, d) - 1
  }
  return sign
}
function skip(j, d) { for (; j <= count; j++) if (depths[j] < d || kinds[j] == "." && depths[j] == d) return j; return count }
END {
  n = length(text); level = 0; plain = ""
  for (i = 1; i <= n; i++) {
    two = substr(text, i, 2); one = substr(text, i, 1)
    if (two == "(*") { level++; plain = plain "  "; i++ }
    else if (two == "*)" && level) { level--; plain = plain "  "; i++ }
    else plain = plain (level && one != "\n" ? " " : one)
  }
  depth = 0
  for (i = 1; i <= n; i++) {
    rest = substr(plain, i, 40)
    if (match(rest, /^[A-Za-z0-9_\047]+(\.[A-Za-z0-9_\047]+)*/)) { push(substr(rest, 1, RLENGTH), i, RLENGTH); i += RLENGTH - 1 }
    else if (match(rest, /^(\/\\|\\\/|<->|->|:=|=>|<>|<=|>=)/)) { push(substr(rest, 1, RLENGTH), i, RLENGTH); i += RLENGTH - 1 }
    else if (rest ~ /^[([{]/) { push("(", i, 1); depth++ }
    else if (rest ~ /^[])}]/) { depth--; push(")", i, 1) }
    else if (rest ~ /^[^ \n]/) push(substr(rest, 1, 1), i, 1)
  }
  name = ""
  for (i = 1; i <= count; i++) {
    if (kinds[i] ~ /^(Definition|Fixpoint|Inductive|Record)$/) name = kinds[i + 1]
    if (kinds[i] != "/\\") continue
    d = depths[i]
    for (j = i - 1; j > 0; j--) {
      if (depths[j] < d || depths[j] == d && kinds[j] ~ /^(:|,|->|<->|\\\/|\/\\|:=|=>|;|then|else|in|\.|\|)$/) break
    }
    right = operand_end(i + 1, d); sign = polarity(right, d)
    # A binder to the left of a conjunct is part of no conjunct, but <-> and -> before it are.
    for (k = j; k > 0 && depths[k] >= d && kinds[k] != "."; k--) if (depths[k] == d && kinds[k] == "<->") sign = 0
    if (sign <= 0) continue
    if (kinds[j] != "/\\" || depths[j] != d) show(j + 1, i)
    show(i + 1, right)
  }
}
function show(from, upto,   at, len, what) {
  at = begins[from]; len = ends[upto - 1] - at; what = substr(plain, at, len); gsub(/[ \n]+/, " ", what)
  print at, len, name, what
}
