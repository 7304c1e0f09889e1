# The conjuncts of a statement file and the fields of its records of propositions, one per line: where it begins, how
# long it is, its definition, its text. Left out are those in a hypothesis, which a statement is weaker with, and on a
# side of <->, which is neither weaker nor stronger without one. Comments are blanked first.
{ text = text $0 "\n" }
function push(kind, at, len) { kinds[++count] = kind; begins[count] = at; ends[count] = at + len; depths[count] = depth }
# What follows token i, at its depth, once the operand that begins there is over.
function operand_end(i, d,   first, j, matches, lets) {
  first = kinds[i]; matches = 0; lets = 0
  for (j = i; j <= count; j++) {
    if (depths[j] < d || kinds[j] == "." && depths[j] == d) return j
    if (depths[j] > d) continue
    if (kinds[j] == "match") matches++
    else if (kinds[j] == "end") { if (!matches--) return j; if (!matches && first == "match") first = "" }
    else if (matches) continue
    else if (kinds[j] == "let") lets++
    else if (kinds[j] == "in") { if (!lets--) return j }
    else if (kinds[j] ~ /^(;|\||with)$/ || kinds[j] == ":=" && !lets) return j
    else if (first !~ /^(forall|exists|let|fun|if|match)$/ && kinds[j] ~ /^(\/\\|\\\/|->|<->|then|else)$/) return j
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
    if (kinds[i] == "Record") fields(i)
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
# The fields of a record of propositions, { name : what; ... }.
function fields(i,   j, k) {
  for (j = i; kinds[j] != ":=" || depths[j] != depths[i]; j++) if (kinds[j] == "." && depths[j] == depths[i]) return
  if (kinds[j - 1] != "Prop") return
  for (j = j + 2; kinds[j - 1] != ")"; j = k + 1) {
    for (k = j; depths[k] == depths[i] + 1 && kinds[k] != ";" || depths[k] > depths[i] + 1; k++);
    if (kinds[j + 1] == ":") show(j + 2, k)
    if (kinds[k] == ")") return
  }
}
function show(from, upto,   at, len, what) {
  at = begins[from]; len = ends[upto - 1] - at; what = substr(plain, at, len); gsub(/[ \n]+/, " ", what)
  print at, len, name, what
}
