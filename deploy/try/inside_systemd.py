#!/usr/bin/env python3
"""The part of systemd.sh that runs on the booted machine: does amalgam.service do what its unit says?

Each test leaves the service running. It is killed and stopped on the way, so this is not for a machine that serves.
"""

import ctypes
import os
import pathlib
import re
import signal
import socket
import subprocess
import threading
import time
import unittest
import urllib.error
import urllib.request

UNIT = "amalgam.service"
CONFIGURATION = pathlib.Path("/etc/amalgam/server.toml")


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options)


def shown(name):
    return run("systemctl", "show", "--value", "-p", name, UNIT, check=True).stdout.strip()


def main_pid():
    return int(shown("MainPID"))


def http(path):
    try:
        with urllib.request.urlopen(f"http://127.0.0.1:7448{path}", timeout=3) as answer:
            return answer.status
    except urllib.error.HTTPError as error:
        return error.code
    except OSError:
        return 0


def metric(name):
    with urllib.request.urlopen("http://127.0.0.1:7448/metrics", timeout=30) as answer:
        return float(re.search(rf"(?m)^{re.escape(name)} (\S+)$", answer.read().decode()).group(1))


def log():
    run("journalctl", "--sync")
    return run("journalctl", "-u", UNIT, "-o", "cat", check=True).stdout


def wait_until(condition, seconds):
    """How long it took, in seconds."""
    begin = time.monotonic()
    while not condition():
        if time.monotonic() - begin > seconds:
            raise AssertionError(f"not within {seconds} s; the log ends with {log()[-2000:]}")
        time.sleep(0.05)
    return time.monotonic() - begin


def composites(frames=5):
    return run("setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups", "amalgam-client", "--synthetic",
               "--size", "320x240", "--frames", str(frames), "--lockstep")


class Unit(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        begin = time.monotonic()
        # Comes back once the server has said that it is ready.
        started = run("systemctl", "enable", "--now", UNIT)
        print(f"started in {time.monotonic() - begin:.1f} s", started.stderr)
        assert started.returncode == 0, log()
        assert http("/readyz") == 200

    def setUp(self):
        # A limit of starts in a time is for services that fail by themselves.
        run("systemctl", "reset-failed", UNIT)

    def tearDown(self):
        wait_until(lambda: (shown("ActiveState"), http("/livez"), http("/readyz")) == ("active", 200, 200), 180)

    def test_10_it_has_no_rights(self):
        process = pathlib.Path(f"/proc/{main_pid()}")
        self.assertEqual(process.owner(), "amalgam")
        status = (process / "status").read_text()
        for line in (r"CapEff:\t0+", r"CapBnd:\t0+", r"CapAmb:\t0+", r"NoNewPrivs:\t1", r"Seccomp:\t2"):
            self.assertRegex(status, f"(?m)^{line}$")
        for kind in ("mnt", "user"):
            self.assertNotEqual((process / "ns" / kind).readlink(), pathlib.Path(f"/proc/1/ns/{kind}").readlink(), kind)
        root = re.search(r"(?m)^\S+ \S+ \S+ \S+ / (\S+)", (process / "mountinfo").read_text())
        self.assertRegex(root.group(1), r"^ro\b")

    def test_11_systemd_could_do_all_that_the_unit_asks_for(self):
        boot = run("journalctl", "-b", "-o", "cat", "_PID=1").stdout
        for line in boot.splitlines():
            if "amalgam" in line.lower():
                self.assertNotRegex(line, "(?i)unknown|ignoring|not supported|failed to|obsolete")

    def test_12_composites(self):
        client = composites(20)
        self.assertEqual(client.returncode, 0, client.stderr)
        print(client.stdout)

    def test_13_only_this_machine_is_let_in(self):
        # An address of another network, which this machine has too.
        run("ip", "address", "add", "198.51.100.1/32", "dev", "lo", check=True)
        self.addCleanup(run, "ip", "address", "del", "198.51.100.1/32", "dev", "lo")
        for port in (7447, 7448):
            socket.create_connection(("127.0.0.1", port), timeout=2, source_address=("127.0.0.2", 0)).close()
            with self.assertRaises(TimeoutError):
                socket.create_connection(("127.0.0.1", port), timeout=2, source_address=("198.51.100.1", 0))

    def test_20_the_watchdog_is_fed(self):
        pid, fed = main_pid(), int(shown("WatchdogTimestampMonotonic"))
        self.assertEqual(shown("WatchdogUSec"), "5s")
        time.sleep(12)
        self.assertEqual(main_pid(), pid)
        self.assertGreater(int(shown("WatchdogTimestampMonotonic")), fed + 10_000_000)

    def test_21_a_reload_takes_over(self):
        pid = main_pid()
        before = metric('amalgam_reloads_total{result="done"}')
        run("systemctl", "reload", UNIT, check=True)
        wait_until(lambda: metric('amalgam_reloads_total{result="done"}') == before + 1, 30)
        wait_until(lambda: shown("SubState") == "running", 10)
        self.assertEqual(main_pid(), pid)
        self.assertEqual(composites().returncode, 0)

    def test_22_a_bad_reload_keeps_the_old(self):
        pid, text = main_pid(), CONFIGURATION.read_text()
        self.addCleanup(CONFIGURATION.write_text, text)
        CONFIGURATION.write_text(text + '\nthreads = "many"\n')
        run("systemctl", "reload", UNIT, check=True)
        wait_until(lambda: metric('amalgam_reloads_total{result="kept_the_old"}') == 1, 30)
        wait_until(lambda: shown("SubState") == "running", 10)
        self.assertEqual(main_pid(), pid)
        self.assertIn("the old scene and configuration stay", log())
        self.assertEqual(composites().returncode, 0)

    def test_23_shaders_are_kept(self):
        self.assertTrue(any(pathlib.Path("/var/cache/amalgam").rglob("*")))

    def restarted_from(self, pid, seconds):
        took = wait_until(lambda: main_pid() not in (0, pid) and http("/readyz") == 200, seconds)
        print(f"serves again after {took:.1f} s")
        self.assertEqual(composites().returncode, 0)

    def test_30_one_that_is_killed_starts_again(self):
        pid = main_pid()
        os.kill(pid, signal.SIGKILL)
        self.restarted_from(pid, 180)

    def test_31_one_that_stands_still_starts_again(self):
        pid = main_pid()
        os.kill(pid, signal.SIGSTOP)
        self.restarted_from(pid, 180)
        self.assertIn("Watchdog timeout", log())

    def test_32_one_whose_renderer_is_stuck_starts_again(self):
        pid = main_pid()
        # More frames than can be rendered, so that it is held in the middle of one.
        client = subprocess.Popen(["amalgam-client", "--synthetic", "--frames", "100000"],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(client.wait)
        self.addCleanup(client.terminate)
        wait_until(lambda: metric("amalgam_frames_sent_total") > 3, 30)
        for thread in threads_but_the_networks(pid):
            hold(thread)
        begin = time.monotonic()
        wait_until(lambda: http("/livez") != 200, 10)
        print(f"/livez fails after {time.monotonic() - begin:.1f} s")
        self.restarted_from(pid, 180)

    def test_40_stop_drains(self):
        client = subprocess.Popen(["amalgam-client", "--synthetic", "--frames", "100000", "--connect-timeout", "2"],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        wait_until(lambda: metric("amalgam_connections") == 1, 10)
        time.sleep(1)
        begin = time.monotonic()
        self.assertEqual(run("systemctl", "stop", UNIT).returncode, 0)
        print(f"stopped in {time.monotonic() - begin:.1f} s with a client")
        self.assertEqual((shown("Result"), shown("ExecMainStatus"), shown("ExecMainCode")), ("success", "0", "1"))
        self.assertIn("draining 1 sessions", log())
        print(client.communicate(timeout=30)[0])
        self.assertEqual(run("systemctl", "start", UNIT).returncode, 0)

    def test_50_an_upgrade_starts_it_again(self):
        pid = main_pid()
        self.assertEqual(run("dpkg", "-i", "/given/amalgam.deb").returncode, 0)
        self.restarted_from(pid, 180)

    def test_51_an_upgrade_leaves_a_stopped_one_stopped(self):
        run("systemctl", "stop", UNIT, check=True)
        self.assertEqual(run("dpkg", "-i", "/given/amalgam.deb").returncode, 0)
        self.assertEqual(shown("ActiveState"), "inactive")
        run("systemctl", "start", UNIT, check=True)


class WhatIsLeft(unittest.TestCase):
    """After Unit, in the order of names."""

    def test_purge(self):
        pid = main_pid()
        purged = run("dpkg", "--purge", "amalgam")
        self.assertEqual(purged.returncode, 0, purged.stderr)
        print(purged.stderr)
        self.assertFalse(pathlib.Path(f"/proc/{pid}").exists(), "the server still runs")
        self.assertEqual(shown("LoadState"), "not-found")
        found = run("find", "/etc", "/usr", "/var/lib", "/var/cache", "/run", "-xdev", "-name", "*amalgam*").stdout.split()
        self.assertEqual(found, [])


def threads_but_the_networks(pid):
    """Those that render and their helpers: all that do not wait for sockets (epoll)."""
    epoll = ("232 ", "281 ", "441 ")  # of x86-64
    tasks = pathlib.Path(f"/proc/{pid}/task").iterdir()
    return [int(task.name) for task in tasks
            if int(task.name) != pid and not (task / "syscall").read_text().startswith(epoll)]


def hold(thread):
    """Stops one thread, as a driver that hangs would, for the rest of its process's life."""
    seize, interrupt, wait_all = 0x4206, 0x4207, 0x40000000
    held = threading.Event()

    def tracer():
        libc = ctypes.CDLL(None)
        if libc.ptrace(seize, thread, None, None) == 0 and libc.ptrace(interrupt, thread, None, None) == 0:
            held.set()
            # Nobody else can reap it, and until then its process has not ended.
            while not os.WIFSIGNALED(os.waitpid(thread, wait_all)[1]):
                pass

    threading.Thread(target=tracer, daemon=True).start()
    if not held.wait(5):
        raise OSError(f"thread {thread} cannot be traced")


if __name__ == "__main__":
    unittest.main(verbosity=2)
