#!/bin/sh
# Has coqc check the certificates of this folder, and reject what was forged. Prints the page docs/verification/certificates.md;
# fails if something is not as it should be. LIMIT: seconds for a file.
cd "$(dirname "$0")" || exit 2
limit=${LIMIT:-300}
coqc -q Straight.v || exit 2
cat <<'PAGE'
# What Coq says

*Proved* ([index](index.md)) rests on polynomials that vanish: left minus right of a claim in normal position. Our programs show
that on lattices of points; here another judge shows it by computing with polynomials.

```sh
cargo run --release -p regge-verify -- --certificates certificates
sh certificates/check.sh > docs/verification/certificates.md
```

The first writes, for N = 2 and 3, the straight-line programs that the library's own code executed as theorems about all real
numbers, a `let` for each step, one theorem for each component; where a root was replaced by the rational function that it is, that
is a theorem as well. The second has `coqc` (Debian's package coq) check them: short programs and quotients by the tactic `field`,
longer ones by the theorem that is behind `ring`, with the expression written beside the statement (`Straight.v`, which is proved
from Coq's library and adds no axiom to those of its real numbers). Next to each claim stands one of its forgeries, which must be rejected, and for no other
reason than that its two sides differ.

Not here: what is the same program on both sides; claims that are not polynomials in normal position; and quotients that would
take `field` minutes (N01, N02, O03, and D13, M20 and O02 for N = 3). Coq does not see that an equation may be brought to its normal position (step 4 of
the [index](index.md)), nor the compiler that recorded the program.

PAGE
seconds() { awk "BEGIN { printf \"%.1f\", $(date +%s.%N) - $1 }"; }
wrong=0
accepted=0
rejected=0
theorems=0
begin=$(date +%s.%N)
echo "| claim | N | theorems | accepted | seconds | forged | rejected |"
echo "|---|---|---|---|---|---|---|"
for file in *_*.v; do
  name=${file%.v}
  label=${name%_*}
  count=$(grep -c '^Theorem' "$file")
  start=$(date +%s.%N)
  if timeout "$limit" coqc -q "$file" >/dev/null 2>"$name.err"; then
    verdict=yes
    accepted=$((accepted + 1))
    theorems=$((theorems + count))
  else
    verdict=NO
    wrong=1
  fi
  took=$(seconds "$start")
  forged="-"
  refused="-"
  if [ -f "forged/$file" ]; then
    forged=$(sed -n 's/^(\* Forged: \(.*\) \*)$/\1/p' "forged/$file" | sed 's/|/\\|/g')
    if timeout "$limit" coqc -q -R . "" "forged/$file" >/dev/null 2>"forged/$name.err"; then
      refused=NO
      wrong=1
    elif grep -q -e 'has type "true = true"' -e 'not a valid ring equation' -e 'not a valid field equation' "forged/$name.err"; then
      refused=yes
      rejected=$((rejected + 1))
    else
      refused="NO: another error"
      wrong=1
    fi
  fi
  echo "| [$label]($label.md) | ${name#*_} | $count | $verdict | $took | $forged | $refused |"
done
echo
echo "$accepted files with $theorems theorems accepted and $rejected forged ones rejected in $(seconds "$begin") seconds by $(coqc --version | head -n 1)."
exit "$wrong"
