#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Where the simulated base really is: base_truth.py SOCKET prints "time_s x_m y_m speed_mps" 25 times a second."""
import json
import os
import socket
import sys
import tempfile
import time

with tempfile.TemporaryDirectory() as folder:
    own = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    own.bind(os.path.join(folder, "truth"))
    own.settimeout(1)
    while True:
        time.sleep(0.04)
        try:
            own.sendto(b"get", sys.argv[1])
            state = json.loads(own.recv(65536))
        except (OSError, ValueError):
            continue
        print(time.time(), state["x"], state["y"], abs(state["v"]), flush=True)
