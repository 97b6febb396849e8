#!/bin/sh
# Runs a command with an X server of its own, whose number is free on this machine, and ends the server with it.
set -eu
folder=$(mktemp -d)
mkfifo "$folder/number"
exec 3<>"$folder/number"
# Without -noreset the server starts anew, and refuses others meanwhile, when the last window is closed.
Xvfb -displayfd 3 -noreset -screen 0 1400x1000x24 -nolisten tcp 2>/dev/null &
server=$!
trap 'kill $server; rm -r "$folder"' EXIT
read -r number <&3
DISPLAY=":$number" "$@" 3>&-
