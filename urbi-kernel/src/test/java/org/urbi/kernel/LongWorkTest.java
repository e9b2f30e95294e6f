package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.kernel.job.Interruptions;
import urbi.UObject;
import urbi.UValue;

/**
 * Long work of a single function in Java checks regularly whether to continue, in proportion to
 * what it does, so that whatever a client gives it can be ended. What is counted are the checks.
 */
class LongWorkTest {
  /** A million steps, of which a check is made at least each 65,536, less some for rounding. */
  private static final int CHECKS = 12;

  private static final Kernel KERNEL =
      Kernel.builder().virtualTime(true).output(text -> {}).log(line -> {}).start();

  private long checks;

  @BeforeAll
  static void plug() {
    KERNEL.start(Taking.class);
  }

  @AfterAll
  static void close() {
    KERNEL.close();
  }

  private long checksOf(String preparation, String work) {
    Interruptions interruptions = KERNEL.scheduler().interruptions();
    KERNEL.define(
        "begun",
        nothing -> {
          checks = 0;
          interruptions.request(
              KERNEL.scheduler().running().lobby(),
              job -> {
                checks++;
                return false;
              });
          return null;
        });
    KERNEL.define(
        "done",
        nothing -> {
          interruptions.clear(KERNEL.scheduler().running().lobby());
          return null;
        });
    KERNEL.eval("{ " + preparation + "; begun | { " + work + " } | done }");
    return checks;
  }

  @Test
  void littleWorkDoesNotCheckOften() {
    long checked = checksOf("var s = \"ab\"", "s.toUpper");
    assertTrue(checked < CHECKS, checked + " checks");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "s.toUpper",
        "s.toLower",
        "s.isAlpha",
        "s.hash",
        "s.asPrintable",
        "[s].asString",
        "\"%S\" % s",
        "s.replace(\"a\", \"b\")",
        "s[0, 30000].replace(\"a\" * 20000 + \"b\", \"c\")",
        "s.split(\"a\" * 20000 + \"b\")",
        "s.split(\"\")",
        "s.asList",
        "Formatter.new(s)",
        "(\"%999999d\" * 40) % ([1] * 40)",
      })
  void ofLongStrings(String work) {
    long checked = checksOf("var s = \"a\" * 1000000", work);
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "l.hash",
        "l == m",
        "l < m",
        "l.has(t + \"b\")",
        "l.has(u)",
        "l - [u]",
        "[u].subset(l)",
        "l.sort",
        "l.max",
        "l.min",
        "l.join(s)",
        "d == e",
      })
  void ofLongStringsInLists(String work) {
    long checked =
        checksOf(
            "var s = \"a\" * 20000; var t = \"a\" * 20000; var u = \"a\" * 19999 + \"b\";"
                + " var l = [s] * 1000; var m = [t] * 1000; var d = [=>]; var e = [=>];"
                + " for| (var i : 1000) { d[i] = s | e[i] = t }",
            work);
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "l.range(0, 1000).subset(l.reverse)",
        "l.range(0, 1000) - l.reverse",
        "l.sort",
        "k.map(Math.getSlotValue(\"sin\"))",
        "k.hash",
        "k == l * 100",
        "k.has(-1)",
        "m.remove(1)",
        "k.asString",
        "k.join",
        "k.max",
        "k.keys",
        "k.reverse",
        "[0] * 2000000",
        "k + k",
        "k.tail",
        "k.range(0, 900000)",
        "k.hasSame(void.acceptVoid)",
        "1000000.seq",
      })
  void ofLongLists(String work) {
    long checked =
        checksOf(
            "var l = []; for| (var i : 10000) l << i; var k = l * 100; var m = [];"
                + " for| (10000) m << 1 + 0",
            work);
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "d.keys",
        "d.asList",
        "d.asString",
        "d.new",
        "[=>].extend(d)",
        "d.hash",
        "d == e",
        "Pattern.new(e).match(d)",
        "f[-1] = 0",
      })
  void ofLargeDictionaries(String work) {
    long checked =
        checksOf(
            "var d = [=>]; for| (var i : 30000) d[(i * 7919) % 30011] = i; var e = d.new;"
                + " var f = [=>]; for| (var i : 65536) f[i] = i",
            work);
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  /** A component that is given values. */
  public static final class Taking extends UObject {
    public Taking(String name) {
      super(name);
      UBindFunctions("take");
    }

    public boolean take(UValue value) {
      return value.isVoid();
    }
  }

  /** What is in many places of a value is gone through in each, so that little can be endless. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "filter << l",
        "filter << d",
        "g.x->p",
        "g.x->p = 1",
        "Taking.take(l)",
        "Taking.take(d)",
      })
  void ofWhatIsShared(String work) {
    long checked =
        checksOf(
            "var filter = Channel.Filter.new(\"f\"); filter.enabled = false;"
                + " var l = [1]; var d = [\"a\" => 1]; var o = Object.new; var o.x = 1; o.x->p = 1;"
                + " var g = Group.new(o);"
                + " for| (16) { l = [l, l] | d = [\"a\" => d, \"b\" => d] | g = Group.new(g, g) }",
            work);
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "m * m",
        "v.asString",
        "w.asList",
        "w + 1",
        "w * w",
        "Vector.new(l)",
        "n.transpose",
        "n + n",
        "n / 2",
        "n.column(0)",
        "Matrix.new(l, l)",
        "Matrix.new(100000, 10).asString",
        "Matrix.new(100000, 0).asString",
        "Matrix.new(2000000, 0).transpose",
        "Matrix.new(2000, 0) * Matrix.new(0, 1000)",
      })
  void ofMatrices(String work) {
    long checked =
        checksOf(
            "var m = Matrix.new(200, 200); var v = Vector.new(100000.seq); var n = Matrix.new(1000000, 1);"
                + " var l = 1000000.seq; var w = Vector.new(l)",
            work);
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  /** Most of them look at no character. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "((){1000}){1000}",
        "((){1000}+){1000}",
        "(?:(?:){1000}){1000}",
        "(?>(?:){1000}+){1000}",
        "(?x)  ( # ((\n ?: (  # [\n){1 000} ) {1000}",
        "(?x: )#(?:(){1000}){1000}|(?:(){1000}){1000}",
        "[](](?:(){1000}){1000}|(?:(){1000}){1000}",
        "\\\\Q(?x)[\\\\E(){1000}|((){1000}){1000}",
        "(?:\\\\A?){20}(?!)|\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?\\\\A?(?!)",
        "()\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?\\\\1?(?!)",
        "^?^?^?^?^?^?^?^?^?^?^?^?^?^?^?(?!)",
        "(?:|)(?:|)(?:|)(?:|)(?:|)(?:|)(?:|)(?:|)(?:|)(?:|)(?:|)(?:|)(?:|)(?:|)(?:|)(?!)",
        "(?<n>){1000}(?<m>(){1000}){1000}",
        "(?<=((){1000}){1000})",
        "(?:a{0}{1000}{1000}){1000}",
        "(?:(?i){1000}){1000}",
        "(?x)(?:a{0} {1000} ){1000}",
        "(?:\\\\Qa\\\\E{0}{1000}){1000}",
        "(?:\\\\Q\\\\E{1000}){1000}",
        "(?x)(?:\\\\Q\\\\E {1000}){1000}",
        "(?:\\\\G{1000}){1000}",
        "(?:${1000}){1000}",
        "(?:(x{0})\\\\1{1000}){1000}",
      })
  void ofExpressions(String expression) {
    long checked = checksOf("var r = Regexp.new(\"" + expression + "\")", "r.match(\"\")");
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "o.slotNames",
        "o.inspect",
        "Enumeration.new(\"E\", n)",
        "o.protos = l",
      })
  void ofManySlotsAndPrototypes(String work) {
    long checked =
        checksOf(
            "var o = Object.new; var n = []; var l = [Object] * 1000000;"
                + " for| (var i : 60000) { o.setSlot(\"s\" + i, i) | n << \"s\" + i }",
            work);
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  @ParameterizedTest
  @ValueSource(strings = {"System.'assert'(NUMBERS.empty)", "lazily(NUMBERS).asString"})
  void ofTheTextOfCode(String work) {
    String numbers = "[0" + ", 0".repeat(20_000) + "]";
    long checked =
        checksOf(
            "function lazily { call.args[0] }",
            "try { " + work.replace("NUMBERS", numbers) + " } catch {}");
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  @Test
  void ofGroupsOfAMatch() {
    String groups = "(".repeat(30) + "a*" + ")".repeat(30);
    long checked =
        checksOf("var r = Regexp.new(\"" + groups + "\"); r.match(\"a\" * 1000000)", "r.matches");
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  /** There is not as much memory as all of them take. */
  @Test
  void groupsOfAMatchAreCopiedWhenTheyAreAskedFor() {
    String groups = "(".repeat(500) + "a*" + ")".repeat(500);
    assertEquals(
        "true",
        KERNEL
            .eval(
                "{ var s = \"a\" * 20000000; var r = Regexp.new(\""
                    + groups
                    + "\");"
                    + " r.match(s) && r[500] == s }")
            .toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"file.asList", "folder.asList"})
  void ofFiles(String work, @TempDir Path folder) throws IOException {
    Path many = Files.createDirectory(folder.resolve("many"));
    for (int i = 0; i < 6_000; i++) {
      Files.createFile(many.resolve("file" + i));
    }
    Path lines = Files.writeString(folder.resolve("lines"), "\n".repeat(250_000));
    long checked =
        checksOf(
            "var file = File.new(\"" + lines + "\"); var folder = Directory.new(\"" + many + "\")",
            work);
    assertTrue(checked >= CHECKS, checked + " checks");
  }

  /** It takes no room on the disk. */
  @Test
  void aFileThatFitsIntoNoArrayIsNotLoaded(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("huge.u");
    try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
      sparse.setLength(3L << 30);
    }
    String work = "loadFile(\"" + file + "\");";
    UrbiError refused = assertThrows(UrbiError.class, () -> KERNEL.eval(work));
    assertTrue(refused.getMessage().contains("file too large"), refused.getMessage());
  }

  @Test
  void whatCannotBeEndedIsRefused() {
    for (String work :
        List.of(
            "Matrix.new(65536, 1) * Matrix.new(1, 65536)",
            "Matrix.new(16777216, 0) * Matrix.new(0, 16777216)",
            "Path.new(\"/a\" * 100000)",
            "Path.new(\"/\") / (\"a/\" * 100000)",
            "File.new(\"/a\" * 100000)",
            "(\"1\" * 2000000).asFloat",
            "Regexp.new(\"a|\" * 100000)",
            "Regexp.new(\"(?<!)\" * 4000)",
            "Regexp.new(\"(){2000000}\")",
            "Regexp.new(\"(?x)(){2 000 000}\")",
            "Regexp.new(\"\\\\A{2000000,}\")")) {
      UrbiError refused = assertThrows(UrbiError.class, () -> KERNEL.eval(work + ";"), work);
      String told = refused.getMessage();
      assertTrue(
          told.contains("too l") || told.contains("to float") || told.contains("range"), told);
    }
  }

  /** A collection of garbage goes through the whole stack: the deeper it is, the longer. */
  @Test
  void groupsWithinThemselvesAreNotGoneIntoForLong() {
    String deep =
        "{ var o = Object.new; var o.calls = 0; function o.step() { calls++ };"
            + " var g = Group.new(o); g << g;"
            + " try { g.step } catch (var e) { [e.message, o.calls <= 10000] } }";
    assertEquals("[stack space exhausted, true]", KERNEL.eval(deep + ";").toString());
  }

  /** Nobody computes the zeros behind what a number of the machine has. */
  @Test
  void ofManyDecimals() {
    for (String same :
        List.of(
            "\"%.999999f\" % 1.5 == \"1.5\" + \"0\" * 999998",
            "\"%.2000e\" % 1.5e300 == (\"%.1100e\" % 1.5e300).replace(\"e\", \"0\" * 900 + \"e\")",
            "\"%.2000e\" % 0 == \"0.\" + \"0\" * 2000 + \"e+00\"")) {
      assertEquals("true", KERNEL.eval(same + ";").toString(), same);
    }
  }
}
