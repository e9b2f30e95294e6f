package org.urbi.tests.failure;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A class that cannot be loaded, wherever it is first needed. */
class InternalErrorTest {
  @DisplayName("a class is missing: the client is told, the log has the trace, the run goes on")
  @ParameterizedTest(name = "in {0}")
  @CsvSource(
      delimiter = '|',
      value = {
        "the reader   | org.urbi.lang.ast.Ast$Watch | watch(1);",
        "the compiler | org.urbi.kernel.node.Assertion$MessageClaim | assert(true);",
        "a builtin    | org.urbi.kernel.node.Profiler | System.profile(function () {});",
        "an outside worker | org.urbi.kernel.outside.DirectoryWatch | at (Directory.new(\".\").fileCreated?) {};",
        "a background job | org.urbi.kernel.node.Profiler | { System.profile(function () {}) },"
      })
  void goesOn(String where, String missing, String code) throws Exception {
    Programs.Run run =
        Programs.without(
            Set.of(missing),
            "echo(\"before\");",
            code,
            "sleep(0.1s); echo(\"after\");",
            "shutdown;");
    assertAll(
        () -> assertTrue(run.out().contains("*** before"), run::out),
        () ->
            assertTrue(
                run.out()
                    .contains(
                        ":error] !!! internal error: java.lang.NoClassDefFoundError: "
                            + missing.replace('.', '/')),
                run::out),
        () -> assertTrue(run.out().contains("*** after"), run::out),
        () -> assertTrue(run.log().contains("internal error in "), run::log),
        () -> assertTrue(run.log().contains("\tat org.urbi."), run::log),
        () -> assertEquals(0, run.status()));
  }
}
