#include <rift/base/exceptions.h>
#include <rift/io/summary.h>

#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace rift;

TEST(Summary, EveryKeyInOrder)
{
  Summary summary;
  summary.version                  = "0.1.0";
  summary.warnings                 = {"a \"load\"", "two"};
  summary.cells                    = 31564;
  summary.nodes_initial            = 6000;
  summary.nodes_final              = 6500;
  summary.steps                    = 1200;
  summary.time                     = 2e-4;
  summary.time_step                = 1. / 3;
  summary.time_step_limited_by     = "cell 17";
  summary.ranks                    = 2;
  summary.wall_seconds             = 3.5;
  summary.cell_steps_per_second    = 4e7;
  summary.peak_memory_bytes        = 5000000000;
  summary.faces_inserted           = 120;
  summary.faces_broken             = 80;
  summary.fragments                = 3;
  summary.contact_pairs            = 4;
  summary.contact_bytes            = {{"active pairs", 104}};
  summary.energy                   = {{"kinetic", 1.5}, {"strain", 0.25}};
  summary.energy_residual_relative = std::nan("");
  summary.state_hash               = "00ff";
  summary.wall_seconds_by_stage    = {{"insertion", 0.5}, {"contact", 0.25}};

  const TemporaryDirectory directory;
  write_summary(directory / "summary.json", summary);
  EXPECT_EQ(read_file(directory / "summary.json"), R"({
  "version": "0.1.0",
  "completed": true,
  "warnings": [
    "a \"load\"",
    "two"
  ],
  "cells": 31564,
  "nodes_initial": 6000,
  "nodes_final": 6500,
  "steps": 1200,
  "time": 0.0002,
  "time_step": 0.3333333333333333,
  "time_step_limited_by": "cell 17",
  "ranks": 2,
  "wall_seconds": 3.5,
  "cell_steps_per_second": 40000000.0,
  "peak_memory_bytes": 5000000000,
  "faces_inserted": 120,
  "faces_broken": 80,
  "fragments": 3,
  "contact_pairs": 4,
  "contact_bytes": {
    "active pairs": 104.0
  },
  "energy": {
    "kinetic": 1.5,
    "strain": 0.25
  },
  "energy_residual_relative": null,
  "state_hash": "00ff",
  "wall_seconds_by_stage": {
    "insertion": 0.5,
    "contact": 0.25
  }
}
)");
}

TEST(Summary, OfARunThatHasFailed)
{
  const TemporaryDirectory directory;
  Summary                  summary;
  summary.version    = "0.1.0";
  summary.stopped_by = "a \"guard\"";
  write_summary(directory / "summary.json", summary);
  EXPECT_NE(read_file(directory / "summary.json")
              .find("{\n  \"version\": \"0.1.0\",\n  \"completed\": "
                    "false,\n  \"stopped_by\": \"a \\\"guard\\\"\",\n  "
                    "\"warnings\": [],\n  \"cells\": 0,\n"),
            std::string::npos);
}

TEST(Summary, NamesThatAreNotUtf8)
{
  const TemporaryDirectory directory;
  Summary                  summary;
  summary.time_step_limited_by = "gr\xFCn";
  write_summary(directory / "summary.json", summary);
  EXPECT_NE(read_file(directory / "summary.json").find("gr\xEF\xBF\xBDn"),
            std::string::npos);
}

TEST(Summary, CannotBeWritten)
{
  EXPECT_EQ(message_of<DiskError>([] { write_summary("/proc/rift/s", {}); }),
            "Cannot create /proc/rift/s.tmp: No such file or directory. Check "
            "that its folder exists.");
}
