#!/usr/bin/env bash
# Unlock a buffer and wait until it is unlocked. Refused while a vehicle is served there: the answer says which.
#   HOISTWAY=http://localhost:8080 ./buffer-unlock.sh BUFFER1
exec "$(dirname "$0")/device-command.sh" "${1:?which buffer?}" unlock
