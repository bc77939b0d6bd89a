# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A pvserver for tests, alone or on several ranks, on a free port."""
import os
import signal
import socket
import subprocess
import time

import linesets_testing as testing
from paraview import servermanager, simple

SECONDS_TO_START = 60.0


class Server:
    """As context: a server that runs and is connected, with the plugin on both sides. It ends in all
    cases, and must have said nothing unless something else went wrong before."""

    def __init__(self, name, ranks=1):
        self.log = os.path.join(testing.OUTPUT, name + ".log")
        self.ranks = ranks
        self.process = None

    def __enter__(self):
        with socket.socket() as probe:
            probe.bind(("localhost", 0))
            port = probe.getsockname()[1]
        command = [os.environ["LINESETS_PVSERVER"], "--server-port=%d" % port]
        if self.ranks > 1:
            command = [os.environ["LINESETS_MPIEXEC"], "--oversubscribe", "-n", str(self.ranks)
                       ] + command
        os.makedirs(testing.OUTPUT, exist_ok=True)
        with open(self.log, "w", encoding="utf-8") as file:
            # A group of its own, to end all ranks.
            self.process = subprocess.Popen(command, stdout=file, stderr=subprocess.STDOUT,
                                            stdin=subprocess.DEVNULL, start_new_session=True)
        try:
            self.wait()
            if servermanager.ActiveConnection:
                simple.Disconnect()
            simple.Connect("localhost", port)
            for remote in (True, False):
                simple.LoadPlugin(os.environ["LINESETS_PLUGIN"], remote=remote, ns=simple.__dict__)
        except BaseException:
            self.kill()
            raise
        return self

    def wait(self):
        """Not by connecting, which the server would take for its client."""
        end = time.monotonic() + SECONDS_TO_START
        while "Accepting connection" not in self.read_log():
            testing.check(time.monotonic() < end and self.process.poll() is None,
                          "pvserver does not start, see " + self.log)
            time.sleep(0.1)

    def read_log(self):
        with open(self.log, encoding="utf-8") as file:
            return file.read()

    def kill(self):
        """Asks first: mpiexec ends its ranks, which are in groups of their own."""
        for number, seconds in ((signal.SIGTERM, 10.0), (signal.SIGKILL, None)):
            try:
                os.killpg(self.process.pid, number)
                self.process.wait(seconds)
            except ProcessLookupError:
                self.process.wait()
            except subprocess.TimeoutExpired:
                pass

    def __exit__(self, kind, *error):
        try:
            if kind is None:
                simple.Disconnect()
        finally:
            self.kill()
        # ParaView 6.1 says of its own thinning of polygons that it copies indices.
        text = "".join(line for line in self.read_log().splitlines(True)
                       if "ArrayExtractComponent.h" not in line)
        testing.check(kind is not None or not ("ERR|" in text or "WARN|" in text),
                      "the server says nothing: " + text)
        return False
