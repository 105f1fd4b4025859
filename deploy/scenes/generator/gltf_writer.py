"""Collects shapes, materials and nodes and writes them as NAME.gltf and NAME.bin."""

import json
import struct
from pathlib import Path

FLOAT, UINT16, UINT32 = 5126, 5123, 5125
VERTICES, INDICES = 34962, 34963


class GltfWriter:
    def __init__(self, amalgam):
        """amalgam: the scene's extras (world marker, dictionary, marker length, environment)."""
        self.amalgam = amalgam
        self.data = bytearray()
        self.views, self.accessors, self.meshes, self.materials = [], [], [], []
        self.nodes, self.images, self.textures = [], [], []
        self.extensions = set()
        self.geometry = {}

    def _accessor(self, values, kind, component, target, bounds=False):
        flat = [x for value in values for x in value] if kind != "SCALAR" else list(values)
        code = {FLOAT: "f", UINT16: "H", UINT32: "I"}[component]
        self.data += b"\0" * (-len(self.data) % 4)
        packed = struct.pack(f"<{len(flat)}{code}", *flat)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(packed),
                           "target": target})
        self.data += packed
        accessor = {"bufferView": len(self.views) - 1, "componentType": component,
                    "count": len(values), "type": kind}
        if bounds:
            stored = struct.unpack(f"<{len(flat)}{code}", packed)
            accessor["min"] = [min(stored[i::3]) for i in range(3)]
            accessor["max"] = [max(stored[i::3]) for i in range(3)]
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def _geometry(self, shape):
        """Accessors of a shape, written once however many materials it has."""
        if id(shape) not in self.geometry:
            component = UINT16 if len(shape.positions) < 65535 else UINT32
            attributes = {
                "POSITION": self._accessor(shape.positions, "VEC3", FLOAT, VERTICES, bounds=True),
                "NORMAL": self._accessor(shape.normals, "VEC3", FLOAT, VERTICES),
            }
            if shape.uvs:
                attributes["TEXCOORD_0"] = self._accessor(shape.uvs, "VEC2", FLOAT, VERTICES)
            indices = self._accessor(shape.indices, "SCALAR", component, INDICES)
            self.geometry[id(shape)] = (shape, attributes, indices)
        return self.geometry[id(shape)][1:]

    def texture(self, uri):
        self.images.append({"uri": uri})
        self.textures.append({"source": len(self.images) - 1, "sampler": 0})
        return len(self.textures) - 1

    def material(self, name, color, metallic=0.0, roughness=1.0, texture=None, extensions=None,
                 normal_texture=None, emission=None):
        pbr = {"baseColorFactor": [*color, 1.0], "metallicFactor": metallic,
               "roughnessFactor": roughness}
        if texture is not None:
            pbr["baseColorTexture"] = {"index": texture}
        material = {"name": name, "pbrMetallicRoughness": pbr}
        if normal_texture is not None:
            material["normalTexture"] = {"index": normal_texture}
        if emission is not None:
            material["emissiveFactor"] = list(emission)
        if extensions:
            material["extensions"] = extensions
            self.extensions.update(extensions)
        self.materials.append(material)
        return len(self.materials) - 1

    def add(self, name, shape, material, role="virtual", marker=None, **transform):
        """marker: of another than the world's. transform: translation, rotation (x y z w), scale,
        as in glTF."""
        attributes, indices = self._geometry(shape)
        self.meshes.append({"name": name, "primitives": [
            {"attributes": attributes, "indices": indices, "material": material}]})
        extras = {"role": role} if marker is None else {"role": role, "marker": marker}
        self.nodes.append({"name": name, "mesh": len(self.meshes) - 1, **transform,
                           "extras": {"amalgam": extras}})

    def document(self, name, binary_uri):
        """The glTF document of a scene of this name, whose bytes (self.data) are at the URI."""
        document = {
            "asset": {"version": "2.0", "generator": "Amalgam deploy/scenes"},
            "scene": 0,
            "scenes": [{"name": name, "nodes": list(range(len(self.nodes))),
                        "extras": {"amalgam": self.amalgam}}],
            "nodes": self.nodes,
            "meshes": self.meshes,
            "materials": self.materials,
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"uri": binary_uri, "byteLength": len(self.data)}],
        }
        if self.extensions:
            document["extensionsUsed"] = sorted(self.extensions)
        if self.textures:
            document.update(images=self.images, textures=self.textures,
                            samplers=[{"wrapS": 10497, "wrapT": 10497}])
        return document

    def write(self, path, binary_stem=None):
        """binary_stem: of a .bin file that scenes with the same shapes share; default: path's."""
        path = Path(path)
        binary = path.with_name(f"{binary_stem or path.stem}.bin")
        document = self.document(path.stem, binary.name)
        path.write_text(json.dumps(document, indent=1) + "\n")
        binary.write_bytes(self.data)
