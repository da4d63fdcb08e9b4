# What every script here uses: where the controller is, who asks, how to ask and how to read an answer. Source it; it does nothing itself.
HOISTWAY=${HOISTWAY:-http://localhost:8080} # where `hoistway serve` or `make run` answers
ACTOR=${ACTOR:-$(id -un)}                   # your name: it stands in the audit
# HOISTWAY_KEY: the key, where callers have to say who they are (docs/access.md)

# usage WORDS "$@": unless all WORDS were given but those in brackets, print what the script takes and does, and end it with 2; --help:
# print the same, and end it with 0.
usage() {
  local words=$1 word all number=0 missing=""
  shift
  if [[ ${1-} == --help ]]; then
    _head "$words"
    exit 0
  fi
  read -ra all <<<"$words"
  for word in ${all[@]+"${all[@]}"}; do
    [[ $word != \[* ]] || continue
    number=$((number + 1))
    [[ -n ${!number-} ]] || missing+=" $word"
  done
  [[ -n $missing ]] || return 0
  echo "missing:$missing" >&2
  _head "$words" >&2
  exit 2
}

_head() {
  echo "usage: $(basename -- "$0")${1:+ $1}"
  sed -n -e 1d -e '/^#/!q' -e 's/^# \{0,1\}//p' -- "$0"
}

# object NAME=TEXT NAME:=JSON...: print a JSON object. A TEXT may hold quotation marks, backslashes, anything.
object() {
  python3 -c '
import json, re, sys

def refuse(constant):
    raise ValueError(constant)

made = {}
for word in sys.argv[1:]:
    name, raw, value = re.fullmatch(r"(\w+)(:?)=(.*)", word, re.DOTALL).groups()
    try:
        made[name] = json.loads(value, parse_constant=refuse) if raw else value
    except ValueError:
        sys.exit(f"{name}: {value!r} is no number, and none of true, false, null")
print(json.dumps(made))' "$@"
}

# list TEXT...: print a JSON list of texts.
list() { python3 -c 'import json, sys; print(json.dumps(sys.argv[1:]))' "$@"; }

# keyed OPTION OF CURL...: curl with the key, if there is one. It is not among the words of the command, which all users here can see.
keyed() {
  if [[ -n ${HOISTWAY_KEY-} ]]; then
    curl --config <(printf 'header = "Authorization: Bearer %s"\n' "$HOISTWAY_KEY") "$@"
  else
    curl "$@"
  fi
}

# ask METHOD PATH [JSON] [OPTION OF CURL...]: print the answer; if it is a refusal too, which says why and what would help, and then fail.
ask() {
  local method=$1 path=$2 body=${3-}
  shift $(($# < 3 ? $# : 3))
  keyed --silent --show-error --fail-with-body --max-time 90 --request "$method" ${body:+--json "$body"} \
    --header "X-Actor: $ACTOR" "$@" "$HOISTWAY/api/v1$path"
}

# api METHOD PATH [JSON] [OPTION OF CURL...]: the same for an answer that the script reads: a refusal goes to standard error.
api() {
  local answer
  answer=$(ask "$@") || { answer=${answer##*$'\r\n\r\n'} && echo "$1 $2: ${answer:-no answer}" >&2; return 1; }
  printf '%s' "$answer"
}

# field NAME: print one field of the JSON on standard input; names of nested ones are joined by dots. Fails for none; null is printed as
# nothing. No input at all is an answer that did not come, of which was said why.
field() {
  python3 -c '
import json, sys
text = sys.stdin.read()
if not text.strip():
    sys.exit(1)
try:
    value = json.loads(text)
    for key in sys.argv[1].split("."):
        if value is not None:
            value = value[int(key)] if isinstance(value, list) else value[key]
except (ValueError, LookupError, TypeError):
    sys.exit(f"no {sys.argv[1]} in the answer: {text[:300]}")
print("" if value is None else value)' "$1"
}

# items PROGRAM: run a line of Python for each `row` of the list that an answer on standard input holds.
items() {
  python3 -c "
import json, sys
text = sys.stdin.read()
if not text.strip():
    sys.exit(1)
for row in json.loads(text)['items']:
    $1"
}
