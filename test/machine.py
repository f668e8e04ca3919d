# SPDX-License-Identifier: Apache-2.0
"""Virtual machines of Debian 12 with packages of ours, for test/boot and test/budget. Needs root, qemu-system-x86, mmdebstrap."""
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import time

SUITE = ["http://deb.debian.org/debian", "deb http://deb.debian.org/debian-security bookworm-security main"]
SYSTEM = "systemd-sysv,udev,dbus,linux-image-cloud-amd64,iproute2,kmod,initramfs-tools,procps"
MOST_S = 600  # for anything in an emulated machine, which is slow
CONSOLE = "[Service]\nExecStart=\nExecStart=-/sbin/agetty --autologin root --noclear ttyS0 vt102\n"


def run(*words, **more):
    return subprocess.run(words, check=True, text=True, capture_output=True, **more).stdout


def fail(text):
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {text}")


def need_machines():
    if os.geteuid() != 0:
        fail("must run as root")
    for program in ("qemu-system-x86_64", "mmdebstrap"):
        if shutil.which(program) is None:
            fail(f"needs {program}")


def our_packages(folder, *names):
    """Files of bringup/packaging/build in a folder."""
    debs = [next(folder.glob(f"{name}_*.deb"), None) for name in names]
    for name, deb in zip(names, debs):
        if deb is None:
            fail(f"{folder} has no {name}_*.deb; bringup/packaging/build makes it")
    return debs


def inside(root, command):
    return run("unshare", "--mount", "--pid", "--fork", "chroot", root, "sh", "-ec",
               "mount -t proc proc /proc; export DEBIAN_FRONTEND=noninteractive; " + command)


def make_root(root, packages, debs):
    """A Debian with some of its own packages and some of ours."""
    run("mmdebstrap", "--quiet", "--variant=minbase", "--include=" + packages, "bookworm", root, *SUITE)
    os.mkdir(f"{root}/debs")
    for deb in debs:
        shutil.copy(deb, f"{root}/debs")
    inside(root, "apt-get update -q; apt-get install -y -q --no-install-recommends /debs/*.deb")
    shutil.rmtree(f"{root}/debs")


def write(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)


def make_disk(root, folder):
    """The disk, the kernel and its initrd, in a folder, of a root that has SYSTEM."""
    for kind in ("vmlinuz", "initrd"):
        shutil.copy(next(root.glob(f"boot/{kind}*")), folder / kind)
    write(root / "etc/systemd/system/serial-getty@ttyS0.service.d/root.conf", CONSOLE)
    write(root / "etc/fstab", "/dev/vda / ext4 defaults 0 1\n")
    run("truncate", "-s", "1500M", folder / "disk")
    run("mke2fs", "-q", "-t", "ext4", "-d", root, folder / "disk")


def waited(condition, most_s):
    """Seconds until something is so; None when it is not within that time."""
    begin = time.monotonic()
    while not condition():
        if time.monotonic() - begin > most_s:
            return None
        time.sleep(0.05)
    return time.monotonic() - begin


class Machine:
    """The virtual machine of a folder of make_disk, with root's shell on its serial line."""

    def __init__(self, folder, *more):
        line = folder / "console.sock"
        line.unlink(missing_ok=True)
        self.process = subprocess.Popen(
            ["qemu-system-x86_64", "-M", "q35", "-cpu", "max", "-m", "1500", "-display", "none", "-no-reboot",
             "-kernel", folder / "vmlinuz", "-initrd", folder / "initrd", "-append", "root=/dev/vda rw console=ttyS0 quiet",
             "-drive", f"file={folder}/disk,if=virtio,format=raw", "-serial", f"unix:{line},server=on,wait=off", *more])
        self.line = socket.socket(socket.AF_UNIX)
        waited(line.exists, 10)
        self.line.connect(str(line))
        self.line.settimeout(1)
        self.text = ""

    def read(self):
        try:
            self.text += self.line.recv(65536).decode(errors="replace")
        except TimeoutError:
            pass
        return self.text

    def shell(self, command):
        """What a command has printed; None when it fails."""
        if waited(lambda: "root@" in self.read(), MOST_S) is None:
            return None
        # The shell echoes what it is told, so the mark is not in there as a whole.
        mark, before = f"end{time.monotonic_ns()}", len(self.text)
        self.line.sendall(f"{command}; echo {mark[:3]}''{mark[3:]} $?\r".encode())
        if waited(lambda: re.search(mark + r" \d", self.read()), MOST_S) is None:
            return None
        said = re.sub("\x1b[^a-z]*[a-z]\r?", "", self.text[before:].partition("\n")[2]).replace("\r", "")
        return said.partition(mark)[0] if mark + " 0" in said else None

    def cut_power(self):
        self.process.kill()
        self.process.wait()
