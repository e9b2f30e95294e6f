package org.urbi.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.server.options.Failure;
import org.urbi.server.source.SourceText;

class SourceTextTest {
  @Test
  void textIsItsBytes() {
    assertEquals("\u00c3\u00a9", SourceText.bytes("\u00e9"));
  }

  @Test
  void fileIsFramedByItsName() {
    assertEquals("//#push 1 \"a\\\"b\\\\c.u\"\n1;\n//#pop\n", SourceText.framed("a\"b\\c.u", "1;"));
  }

  @Test
  void theFirstLineOfAScriptIsAComment() {
    assertEquals(
        "//#push 1 \"s\"\n// /usr/bin/env urbi\n1;\n//#pop\n",
        SourceText.framed("s", "#! /usr/bin/env urbi\n1;"));
  }

  @Test
  void bytesOfAFileAreKept(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("bytes.u");
    Files.write(file, new byte[] {(byte) 0xff, 0, ';'});
    assertEquals(
        "//#push 1 \"" + file + "\"\n\u00ff\0;\n//#pop\n", SourceText.file(file.toString()));
  }

  @Test
  void missingFileIsReportedByName() {
    Failure failure = assertThrows(Failure.class, () -> SourceText.file("no/such.u"));
    assertEquals("no such file: no/such.u", failure.getMessage());
    assertEquals(1, failure.status());
  }

  @Test
  void aModuleIsLoadedByName() {
    assertEquals("loadModule(\"a/machine\");\n", SourceText.loadModule("a/machine"));
  }
}
