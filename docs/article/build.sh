#!/bin/sh
# Makes the article: its certificates, tables and figures by the program, then the PDF. Every number that a line
# "%! COMMAND => TEXT" of article.tex claims is looked for in what the command prints; every \coq{NAME} is looked for in
# proofs/coq. Any miss fails.
#
#     sh docs/article/build.sh [FOLDER]        FOLDER is target/article unless given; the PDF is FOLDER/article.pdf
#
# Needs pdflatex and bibtex with the packages of texlive-latex-recommended, texlive-fonts-recommended and lmodern,
# rsvg-convert, and the program: GRAZING, or target/debug/grazing, or one that cargo builds.
set -eu
cd "$(dirname "$0")/../.."
root=$PWD
folder=${1:-${CARGO_TARGET_DIR:-target}/article}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
grazing=${GRAZING:-${CARGO_TARGET_DIR:-$root/target}/debug/grazing}
[ -x "$grazing" ] || cargo build --quiet --package grazing-shell
source=$root/docs/article/article.tex
fail() { echo "docs/article: $*" >&2; exit 1; }

# The names of theorems, statements and files.
missing=
for name in $(grep -v '^%' "$source" | grep -o '\\coq{[^}]*}' | grep -v '#1' | sed 's/\\coq{\(.*\)}/\1/' | sort -u); do
    case $name in
    *.v) [ -f "proofs/coq/$name" ] || missing="$missing $name" ;;
    *) grep -qE "^(Theorem|Definition|Lemma) $name( |:)" proofs/coq/*.v || missing="$missing $name" ;;
    esac
done
[ -z "$missing" ] || fail "not in proofs/coq:$missing"

# Certificates, with fixed names, and their hashes.
made=$folder/made
rm -rf "$made"
mkdir -p "$made"
cd "$made"
quietly() { "$@" >"$folder/last.txt" 2>&1 || { cat "$folder/last.txt" >&2; fail "failed: $*"; }; }
quietly "$grazing" verify 3..=100 --certificate theorem2.txt
quietly "$grazing" verify 3..=8 --certificate theorem2-8.txt
quietly "$grazing" cover 3..=8 --certificate cover-8.txt
quietly "$grazing" word --a1 -1/4 --a2 1/2 --certificate word.txt
quietly "$grazing" verify --entropy --certificate entropy.txt
quietly python3 "$root/docs/article/suprema.py"
quietly "$grazing" run "$root/examples/scenes/nordmark-2001-chaos.toml" -o chaos
for file in theorem2.txt theorem2-8.txt cover-8.txt word.txt entropy.txt chaos/*.certificate; do
    quietly "$grazing" check "$file"
done

# The numbers of the text. Each command runs once, in the root, without writing there.
cd "$root"
answers=$folder/answers
rm -rf "$answers"
mkdir -p "$answers"
numbers=0
grep '^%! ' "$source" | sed 's/^%! //' >"$folder/claims.txt"
while IFS= read -r claim; do
    command=${claim%% => *}
    text=${claim#* => }
    answer=$answers/$(printf %s "$command" | cksum | cut -d' ' -f1)
    if [ ! -f "$answer" ]; then
        case $command in
        "grazing run "*) (cd "$folder" && "$grazing" run "$root/${command#grazing run }" -o "$folder/run") >"$answer" 2>&1 ;;
        "grazing "*) "$grazing" ${command#grazing } >"$answer" 2>&1 ;;
        "python3 docs/article/"*) $command >"$answer" 2>&1 ;;
        *) fail "not a command of the program: $command" ;;
        esac || fail "failed: $command"
    fi
    grep -qF -- "$text" "$answer" || fail "\`$command\` does not print: $text"
    numbers=$((numbers + 1))
done <"$folder/claims.txt"

# Tables.
cd "$made"
"$grazing" intervals 3..=8 --format latex --cite theorem2-8.txt --cite cover-8.txt -o "$folder/intervals-table.tex"
"$grazing" boundary 8 --digits 9 --format latex --cite cover-8.txt -o "$folder/boundary-table.tex"
"$grazing" intervals --measure 3..=12 --digits 6 --format latex -o "$folder/measure-table.tex"
"$grazing" word --r 1.25 --s 0.37 --returns --format latex -o "$folder/returns-table.tex"
hash() { sha256sum "$1" | cut -c1-64 | sed 's/\(................\)/\1\\allowbreak /g'; }
row() { printf '\\texttt{%s} & %s & \\texttt{%s}\\\\\n' "$1" "$2" "$(hash "$3")"; }
{
    cat <<'HEAD'
\begin{table}[t]\centering
\caption{Certificates, made with this text: what each proves, and its SHA-256.}\label{tab:certificates}
\footnotesize
\begin{tabular}{@{}lp{.36\linewidth}>{\raggedright\arraybackslash}p{.37\linewidth}@{}}\toprule
name & proves & SHA-256\\\midrule
HEAD
    row theorem2 'Theorem 2 for $3\le n\le100$: \cmd{grazing verify 3..=100}' theorem2.txt
    row theorem2-8 'the same for $3\le n\le8$' theorem2-8.txt
    row cover-8 'Conjecture 1 for $3\le n\le8$, $r\le1-1/n^3$: \cmd{grazing cover 3..=8}' cover-8.txt
    row word 'the word at $a_1=-\frac14$, $a_2=\frac12$: \cmd{grazing word}' word.txt
    row entropy 'the suprema of the entropy: \cmd{grazing verify --entropy}' entropy.txt
    row always '$\{1,2\}$, every $\mu>0$' chaos/always.certificate
    row few '$\{1,2\}$, $0<\mu\le0.2$, and no others' chaos/few.certificate
    row figure10 '$\{1,2,3\}$, $0<\mu\le0.003$, and no others' chaos/figure10.certificate
    row further '$\{1,2,3\}$, $\mu=0.0038$' chaos/further.certificate
    row cell '$\{1,2\}$ for a range of $d$ and $w$' chaos/cell.certificate
    row softer '$\{1,2\}$, $\tau=0.9$' chaos/softer.certificate
    row faster '$\{1,2,3\}$, $w=10$, and no others' chaos/faster.certificate
    row before 'a graph on $\{1,2,3\}$, $\gamma<0$' chaos/before.certificate
    printf '%s\n' '\bottomrule\end{tabular}\end{table}'
} >"$folder/certificates-table.tex"

# Figures: of the proofs, or the program's own PDF, if it was built with the feature `print`.
for figure in $(grep -o '\\includegraphics\[[^]]*\]{[^}]*}' "$source" | sed 's/.*{\(.*\)}/\1/'); do
    number=${figure#figure}
    if [ -f "$root/proofs/figures/$figure.svg" ]; then
        rsvg-convert -f pdf -o "$folder/$figure.pdf" "$root/proofs/figures/$figure.svg"
    elif ! "$grazing" figure "$number" -o "$folder/$figure.pdf" >"$folder/last.txt" 2>&1; then
        quietly "$grazing" figure "$number" -o "$folder/$figure.svg"
        rsvg-convert -f pdf -o "$folder/$figure.pdf" "$folder/$figure.svg"
    fi
done

cd "$folder"
cp "$source" "$root/docs/article/references.bib" .
latex() { pdflatex -interaction=nonstopmode -halt-on-error article.tex >"$folder/last.txt" || { tail -40 "$folder/last.txt" >&2; fail "pdflatex"; }; }
latex
bibtex -terse article || fail "bibtex"
latex
latex
! grep -E 'undefined|multiply defined' article.log || fail "references"
pages=$(grep -o 'Output written on article.pdf ([0-9]*' article.log | grep -o '[0-9]*$')
wide=$(grep -c '^Overfull \\hbox' article.log || true)
echo "$folder/article.pdf: $pages pages, $numbers numbers found, $wide lines too wide"
[ "$wide" = 0 ] || { grep -A1 '^Overfull \\hbox' article.log >&2; fail "lines too wide"; }
