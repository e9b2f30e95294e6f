package org.urbi.tests;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.urbi.server.Version;

/** The version of the software is told in few places, and they agree. */
class VersionTest {
  private static final Path ROOT = Path.of("..");

  private static String found(String file, String expression) throws Exception {
    Matcher matcher = Pattern.compile(expression).matcher(Files.readString(ROOT.resolve(file)));
    assertTrue(matcher.find(), file);
    return matcher.group(1);
  }

  @Test
  void theFilesForOtherBuildSystemsHaveTheVersion() throws Exception {
    String version = found("pom.xml", "(?m)^  <version>(.+)</version>$");
    assertEquals(version, Version.number());
    assertEquals(version, found("share/pkgconfig/urbi.pc", "(?m)^Version: (.+)$"));
    assertEquals(
        version, found("share/cmake/Urbi/UrbiConfigVersion.cmake", "PACKAGE_VERSION \"(.+?)\""));
    assertEquals(version, found("editors/vscode/package.json", "\"version\": \"(.+?)\""));
    assertEquals(version, found("editors/emacs/urbiscript-mode.el", "(?m)^;; Version: (.+)$"));
  }

  @Test
  void theDialectIsToldBesideIt() {
    assertTrue(
        Version.text("urbi")
            .startsWith(
                "urbi version "
                    + Version.number()
                    + " (Urbi on the JVM), urbiscript of Urbi 2.7.5\n"));
  }

  private static Process notes(String... arguments) throws Exception {
    ProcessBuilder script = new ProcessBuilder("../scripts/release-notes");
    script.command().addAll(List.of(arguments));
    return script.redirectErrorStream(true).start();
  }

  @Test
  void theNotesOfAVersionArePrinted() throws Exception {
    Process present = notes(Version.number());
    String text = new String(present.getInputStream().readAllBytes(), UTF_8);
    assertTrue(text.startsWith("### ") && text.endsWith("\n") && !text.contains("\n## "), text);
    assertEquals(0, present.waitFor());
    Process unknown = notes("0.0.1");
    assertEquals(
        "release-notes: CHANGELOG.md has no version 0.0.1\n",
        new String(unknown.getInputStream().readAllBytes(), UTF_8));
    assertEquals(1, unknown.waitFor());
  }

  /**
   * Notes that cannot be written, since the disk is full or a pipe has no reader, are not missing
   * ones.
   */
  @Test
  void notesThatCannotBeWrittenAreNotCalledMissing() throws Exception {
    Process full =
        new ProcessBuilder(
                "sh", "-c", "../scripts/release-notes " + Version.number() + " >/dev/full")
            .start();
    String said = new String(full.getErrorStream().readAllBytes(), UTF_8);
    assertFalse(said.contains("has no version"), said);
    assertNotEquals(0, full.waitFor());
  }

  @Test
  void everyReleaseInTheChangelogHasItsDate() throws Exception {
    String text = Files.readString(ROOT.resolve("CHANGELOG.md"));
    assertTrue(text.contains("\n## [Unreleased]\n"));
    text.lines()
        .filter(line -> line.startsWith("## ") && !line.equals("## [Unreleased]"))
        .forEach(line ->
            assertTrue(line.matches("## \\[\\d+\\.\\d+\\.\\d+] - \\d{4}-\\d{2}-\\d{2}"), line));
  }
}
