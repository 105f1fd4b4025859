// All limits of the glTF reader. A file is a stranger's: it may be small and ask for any amount of
// memory or time, because its parts refer to each other as often as they like.
#pragma once

#include <cstddef>

namespace amalgam::scene {

// Text. The tree of values takes about 100 bytes a value, and its walkers a level of the stack.
constexpr int kMaxJsonDepth = 64;
constexpr std::size_t kMaxJsonValues = 4'000'000;

// A file that is read whole: the scene, a buffer, a picture. Readable in some seconds.
constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;
constexpr std::size_t kMaxEnvironmentFileBytes = std::size_t{256} << 20;

// Buffers together, and likewise what meshoptimizer makes of them, and Draco's compressed blocks
// as often as primitives name them.
constexpr long long kMaxBufferBytes = 512LL << 20;

// Encoded pictures together, as often as images name them; and their texels, without mips.
constexpr std::size_t kMaxPictureBytes = std::size_t{512} << 20;
constexpr std::size_t kMaxTexels = std::size_t{128} << 20;

// Of one collection, such as nodes.
constexpr std::size_t kMaxElements = 200'000;

// An element's ancestors: bounds the walk to its root.
constexpr std::size_t kMaxNodeDepth = 1000;

// Elements of one accessor; and of one whose numbers are all zero, because no byte of the file
// stands behind them.
constexpr long long kMaxAccessorElements = 100'000'000;
constexpr long long kMaxZeros = 1'000'000;

// Numbers that are looked at only to note what is wrong with them: about a second.
constexpr std::size_t kMaxUnreadNumbers = 100'000'000;

// Vertices, and triangles, of all primitives together: some GiB. Primitives may share accessors,
// and a Draco block holds more than its bytes.
constexpr std::size_t kMaxVertices = 50'000'000;
constexpr std::size_t kMaxTriangles = 50'000'000;

// What Draco's blocks become: vertices of 40 bytes, some more attributes for each than are read.
constexpr std::size_t kMaxDracoBytes = std::size_t{2} << 30;

// Primitives of all nodes, each once for every node that shows it: about 250 bytes each.
constexpr std::size_t kMaxInstances = 1'000'000;

// A huge file may repeat one slip everywhere.
constexpr std::size_t kMaxNotes = 1000;

// Marker numbers. OpenCV's own dictionaries have at most 2320.
constexpr int kMaxMarker = 1'000'000;

// Quantities without a bound of their own: far below what float can hold.
constexpr double kMaxQuantity = 1e30;

// Light's intensity, emission and absorption (1/m), which are products or quotients of such
// quantities. Larger ones become this. Its square is still a float.
constexpr double kMaxProduct = 1e12;

// A normal texture's scale, either way. The square of a bent normal's length stays a float.
constexpr double kMaxNormalScale = 1e6;

// Metres. The tracer's rays start within 1e12 of the origin, and Embree drops triangles beyond
// 1.8e18 without a word (numerics B12).
constexpr double kMaxPlace = 1e11;     // entries of a node's transform, with its parents'
constexpr double kMaxPosition = 1e12;  // a vertex in its mesh

}  // namespace amalgam::scene
