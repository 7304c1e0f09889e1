#!/bin/sh
# Lines of code that each kind of certificate rests on: no blank lines, no comments, no tests.
cd "$(dirname "$0")/src" || exit 2
count() {
    awk 'FNR == 1 { test = 0 } /^#\[cfg\(test\)\]/ { getline; if ($0 !~ /;$/) test = 1; next }
         !test && !/^[[:space:]]*$/ && !/^[[:space:]]*\/\// { lines++ } END { print lines + 0 }' "$@"
}
shared="lib.rs arithmetic.rs header.rs lines.rs rejection.rs"
numbers="decimal.rs interval.rs"
touch="$numbers $(ls touch/*.rs)"
motion="$numbers sha256.rs $(ls motion/*.rs | grep -v tests.rs)"
echo "theorem2 $(count $shared theorem2/*.rs)"
echo "cover    $(count $shared theorem2/intervals.rs cover/*.rs)"
echo "orbit    $(count $shared $motion orbit/*.rs)"
echo "event    $(count $shared $motion event/*.rs)"
echo "machine  $(count $shared $motion orbit/text.rs machine/*.rs)"
echo "chaos    $(count $shared $touch $(ls chaos/*.rs | grep -v tests.rs))"
echo "range    $(count $shared $touch $(ls range/*.rs | grep -v tests.rs))"
echo "nothing  $(count $shared $(echo $touch | tr ' ' '\n' | grep -v graph.rs) nothing/*.rs)"
echo "branch   $(count $shared $motion orbit/text.rs orbit/proof.rs event/ranges.rs event/quotient.rs branch/*.rs)"
echo "single   $(count $shared $numbers touch/mod.rs touch/carry.rs touch/flow.rs touch/text.rs touch/wall.rs $(ls single/*.rs | grep -v tests.rs))"
echo "attractor $(count $shared $numbers touch/mod.rs touch/about.rs touch/flow.rs touch/text.rs touch/wall.rs motion/mod.rs motion/exponential.rs motion/number.rs $(ls attractor/*.rs attractor/cells/*.rs | grep -v tests.rs))"
echo "share    $(count $shared $numbers touch/mod.rs touch/flow.rs touch/text.rs word/integer.rs word/number.rs word/set.rs share/*.rs)"
echo "word     $(count $shared word/*.rs)"
echo "entropy  $(count $shared entropy/*.rs)"
echo "of which shared by all $(count $shared); grazing-check itself $(count main.rs); in all $(count $shared main.rs theorem2/*.rs cover/*.rs share/*.rs $motion orbit/*.rs event/*.rs branch/*.rs machine/*.rs word/*.rs entropy/*.rs touch/*.rs $(ls attractor/*.rs attractor/cells/*.rs chaos/*.rs nothing/*.rs range/*.rs single/*.rs | grep -v tests.rs))"
