#include "report/run_row.h"

#include <functional>
#include <stdexcept>

namespace amalgam::report {
namespace {

struct Column {
  const char* name;
  std::function<std::string(const RunRow&)> write;
  std::function<void(RunRow&, const std::string&)> read;
};

Column column(const char* name, std::string RunRow::*member) {
  return {name, [member](const RunRow& row) { return row.*member; },
          [member](RunRow& row, const std::string& text) { row.*member = text; }};
}

Column column(const char* name, std::uint64_t RunRow::*member) {
  return {name, [member](const RunRow& row) { return std::to_string(row.*member); },
          [member](RunRow& row, const std::string& text) { row.*member = std::stoull(text); }};
}

Column column(const char* name, double RunRow::*member) {
  return {name,
          [member](const RunRow& row) {
            const double value = row.*member;
            return value == value ? csv_number(value) : std::string();
          },
          [member](RunRow& row, const std::string& text) { row.*member = parse_csv_number(text); }};
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all{
      column("commit", &RunRow::commit),
      column("host_cpu", &RunRow::host_cpu),
      column("isa", &RunRow::isa),
      column("threads", &RunRow::threads),
      column("scene", &RunRow::scene),
      column("width", &RunRow::width),
      column("height", &RunRow::height),
      column("sweep", &RunRow::sweep),
      column("point", &RunRow::point),
      column("value", &RunRow::value),
      column("renderer", &RunRow::renderer),
      column("samples", &RunRow::samples),
      column("adaptive_threshold", &RunRow::adaptive_threshold),
      column("max_depth", &RunRow::max_depth),
      column("importance_cutoff", &RunRow::importance_cutoff),
      column("fresnel", &RunRow::fresnel),
      column("env_lights", &RunRow::env_lights),
      column("shadow_edges", &RunRow::shadow_edges),
      column("render_scale", &RunRow::render_scale),
      column("exposure", &RunRow::exposure),
      column("jpeg_quality", &RunRow::jpeg_quality),
      column("reference", &RunRow::reference),
      column("run", &RunRow::run),
      column("offset", &RunRow::offset),
      column("offset_x_px", &RunRow::offset_x),
      column("offset_y_px", &RunRow::offset_y),
      column("time_ms", &RunRow::time_ms),
      column("cpu_ms", &RunRow::cpu_ms),
      column("stages_ms", &RunRow::stages_ms),
      column("rays_primary", &RunRow::rays_primary),
      column("rays_reflection", &RunRow::rays_reflection),
      column("rays_refraction", &RunRow::rays_refraction),
      column("rays_shadow", &RunRow::rays_shadow),
      column("rays_lookup", &RunRow::rays_lookup),
      column("output_bytes", &RunRow::output_bytes),
      column("mae", &RunRow::mae),
      column("mse", &RunRow::mse),
      column("mrse", &RunRow::mrse),
      column("ssim", &RunRow::ssim),
      column("psnr_db", &RunRow::psnr),
      column("maximum", &RunRow::maximum),
      column("nonfinite", &RunRow::nonfinite),
      column("limit_mae", &RunRow::limit_mae),
      column("floor_mae", &RunRow::floor_mae),
      column("jpeg_mae", &RunRow::jpeg_mae),
      column("truncation_bound_mean", &RunRow::truncation_bound_mean),
      column("truncation_bound_worst", &RunRow::truncation_bound_worst),
  };
  return all;
}

}  // namespace

CsvRow run_columns() {
  CsvRow names;
  for (const Column& column : columns()) names.emplace_back(column.name);
  return names;
}

CsvRow to_csv(const RunRow& row) {
  CsvRow fields;
  for (const Column& column : columns()) fields.push_back(column.write(row));
  return fields;
}

RunRow parse_run_row(const CsvRow& fields) {
  if (fields.size() != columns().size()) {
    throw std::invalid_argument("a row has " + std::to_string(fields.size()) + " fields, not " +
                                std::to_string(columns().size()));
  }
  RunRow row;
  for (std::size_t i = 0; i < fields.size(); ++i) columns()[i].read(row, fields[i]);
  return row;
}

std::string run_key(const RunRow& row) {
  return csv_line({row.scene, row.sweep, row.point, std::to_string(row.run)});
}

}  // namespace amalgam::report
