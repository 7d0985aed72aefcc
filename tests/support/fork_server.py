"""Runs the program many times by a process that has its libraries loaded and forks for each run.

    with ForkServer(path) as server:
        done = server.run(["beams.prm", "--check"], folder, seconds=20)
        done.code, done.stderr, done.seconds, done.peak_megabytes
"""
import dataclasses
import json
import pathlib
import subprocess
import tempfile


@dataclasses.dataclass
class Done:
    code: int               # -1 when a signal ended it
    signal: int
    timed_out: bool
    seconds: float          # of processor time
    peak_megabytes: float
    stdout: str
    stderr: str


class ForkServer:
    """`program` is build/tests/fork_server."""

    def __init__(self, program):
        self.printed = tempfile.TemporaryDirectory()
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        text=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.wait()
        self.process.stdout.close()
        self.printed.cleanup()

    def run(self, arguments, folder, seconds=0, megabytes=0, file_bytes=0):
        """Runs the program in `folder`; limits of processor time, address space, file size; 0: none."""
        files = {name: str(pathlib.Path(self.printed.name) / name) for name in ("stdout", "stderr")}
        request = {"arguments": [str(argument) for argument in arguments], "folder": str(folder),
                   "seconds": seconds, "megabytes": megabytes, "file_bytes": file_bytes, **files}
        self.process.stdin.write(json.dumps(request) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        answer["timed_out"] = bool(answer["timed_out"])
        texts = {name: pathlib.Path(file).read_bytes().decode(errors="replace")
                 for name, file in files.items()}
        return Done(**answer, **texts)
