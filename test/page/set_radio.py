#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Changes the emulated radio of a run: set_radio.py SOCKET "set loss 0.3" ..."""
import socket
import sys

with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as own:
    for command in sys.argv[2:]:
        own.sendto(command.encode(), sys.argv[1])
