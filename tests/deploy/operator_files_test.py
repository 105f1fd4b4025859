#!/usr/bin/env python3
"""operator_files_test.py SERVER LOAD SOURCE: what operators are given fits the server that they get.

Starts the server with the default configuration and a little load, and compares its metrics and options with the
dashboard, the alerts and the manifests.
"""

import json
import pathlib
import re
import subprocess
import sys
import unittest
import urllib.request

SERVER, LOAD, SOURCE = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
DEPLOY = SOURCE / "deploy"


def metrics_of_a_server_at_work():
    server = subprocess.Popen(
        [SERVER, "--config", DEPLOY / "systemd/server.toml", "--listen", "127.0.0.1:0", "--admin", "127.0.0.1:0",
         "--scene", DEPLOY / "scenes/diffuse.gltf", "--renderer", "raytrace", "--target-fps", "30",
         "--log-level", "error"],
        stdout=subprocess.PIPE, text=True)
    try:
        said = server.stdout.readline().split()
        listen, admin = said[2], said[4]
        subprocess.run([LOAD, "--server", listen, "--frames", "3", "--rate", "5"], check=True, capture_output=True)
        with urllib.request.urlopen(f"http://{admin}/metrics", timeout=10) as page:
            return page.read().decode()
    finally:
        server.terminate()
        server.communicate(timeout=25)


def expressions(path):
    if path.suffix == ".json":
        return [target["expr"] for panel in json.loads(path.read_text())["panels"] for target in panel["targets"]]
    return re.findall(r"expr: (.+)", path.read_text())


class OperatorFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.metrics = metrics_of_a_server_at_work()
        cls.names = set(re.findall(r"^(\w+)[{ ]", cls.metrics, re.MULTILINE))
        help_text = subprocess.run([SERVER, "--help"], check=True, capture_output=True, text=True).stdout
        cls.options = set(re.findall(r"^ +(?:-\w,)?--([a-z-]+)", help_text, re.MULTILINE))

    def test_what_is_plotted_and_alerted_on_is_measured(self):
        used = 0
        for path in (DEPLOY / "grafana/amalgam.json", DEPLOY / "prometheus/amalgam.rules.yml"):
            for expression in expressions(path):
                for name, labels in re.findall(r"((?:amalgam|process)_\w+)(?:\{([^}]*)\})?", expression):
                    used += 1
                    self.assertIn(name, self.names, f"{path.name}: {expression}")
                    for label, values in re.findall(r'(\w+)=~?"([^"$]+)"', labels):
                        if label in ("job", "instance"):
                            continue  # Prometheus' own
                        for value in values.split("|"):
                            self.assertRegex(self.metrics, rf'(?m)^{name}\{{.*{label}="{value}"', expression)
        self.assertGreater(used, 20)

    def test_sums_are_by_labels_that_are_there(self):
        for path in (DEPLOY / "grafana/amalgam.json", DEPLOY / "prometheus/amalgam.rules.yml"):
            for expression in expressions(path):
                for by, name in re.findall(r"by \(([\w, ]+)\) \((?:rate|increase)\((\w+)", expression):
                    for label in set(by.replace(" ", "").split(",")) - {"instance", "job"}:
                        self.assertRegex(self.metrics, rf"(?m)^{name}\{{.*{label}=", expression)

    def test_options_are_the_servers(self):
        files = ("container/Containerfile", "kubernetes/amalgam.yaml", "haproxy/haproxy.cfg", "systemd/amalgam.service")
        used = []
        for file in files:
            text = (DEPLOY / file).read_text()
            text = re.sub(r"(?m)^.*(kubectl|podman|apt-get|security-opt|COPY|HEALTHCHECK).*$", "", text)
            used += [(file, name) for name in re.findall(r"--([a-z]+(?:-[a-z]+)*)", text)]
        text = (DEPLOY / "systemd/server.toml").read_text()
        used += [("server.toml", name) for name in re.findall(r"(?m)^(?:# )?([a-z-]+) = ", text)]
        self.assertGreater(len(used), 20)
        for file, name in used:
            self.assertIn(name, self.options, file)

    def test_kubernetes_objects_fit_each_other(self):
        try:
            import yaml
        except ImportError:
            self.skipTest("python3-yaml is not installed")
        objects = {o["kind"]: o for o in yaml.safe_load_all((DEPLOY / "kubernetes/amalgam.yaml").read_text())}
        self.assertEqual(set(objects), {"Deployment", "Service", "PodDisruptionBudget", "HorizontalPodAutoscaler"})
        deployment = objects["Deployment"]
        template = deployment["spec"]["template"]
        labels = template["metadata"]["labels"]
        for selector in (deployment["spec"]["selector"]["matchLabels"], objects["Service"]["spec"]["selector"],
                         objects["PodDisruptionBudget"]["spec"]["selector"]["matchLabels"]):
            self.assertEqual(selector, labels)
        pod, container = template["spec"], template["spec"]["containers"][0]
        ports = {port["name"]: port["containerPort"] for port in container["ports"]}
        self.assertEqual(template["metadata"]["annotations"]["prometheus.io/port"], str(ports["admin"]))
        self.assertIn(objects["Service"]["spec"]["ports"][0]["targetPort"], ports)
        for probe in ("startupProbe", "livenessProbe", "readinessProbe"):
            self.assertIn(container[probe]["httpGet"]["path"], ("/livez", "/readyz"))
            self.assertIn(container[probe]["httpGet"]["port"], ports)
        self.assertEqual(container["livenessProbe"]["httpGet"]["path"], "/livez")  # /readyz would end those that drain
        self.assertTrue(pod["securityContext"]["runAsNonRoot"])
        self.assertTrue(container["securityContext"]["readOnlyRootFilesystem"])
        self.assertEqual(pod["volumes"][0]["secret"]["defaultMode"] & 0o007, 0)
        self.assertEqual({mount["name"] for mount in container["volumeMounts"]}, {v["name"] for v in pod["volumes"]})
        scaler = objects["HorizontalPodAutoscaler"]["spec"]
        self.assertEqual(scaler["scaleTargetRef"]["name"], deployment["metadata"]["name"])
        for metric in scaler["metrics"]:
            self.assertIn(metric["pods"]["metric"]["name"], self.names)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
