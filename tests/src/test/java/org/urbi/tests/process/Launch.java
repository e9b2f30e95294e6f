package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import org.urbi.tests.process.JavaProcess.Setting;

/** A program that runs UObjects, in a setting, and {@code urbi-send} beside it. */
record Launch(Setting setting, String mainClass) {
  private static final String SEND = "org.urbi.server.tools.UrbiSend";

  JavaProcess start(String... arguments) throws IOException {
    return JavaProcess.start(setting, mainClass, List.of(arguments));
  }

  /** Runs it to its end, which has to be a good one; time stamps do not count. */
  String output(String... arguments) throws Exception {
    return outputOf(mainClass, arguments);
  }

  private String outputOf(String program, String... arguments) throws Exception {
    try (JavaProcess process = JavaProcess.start(setting, program, List.of(arguments))) {
      assertEquals(0, process.awaitEnd(), process::text);
      return plain(process.text());
    }
  }

  /** It says what is wrong, and no more. */
  void fails(int status, String message, String... arguments) throws Exception {
    try (JavaProcess process = start(arguments)) {
      assertEquals(status, process.awaitEnd(), process::text);
      assertTrue(process.text().contains(message), process::text);
      assertTrue(!process.text().contains("\tat "), process::text);
    }
  }

  /** The dialogue at the end of "Running UObjects". */
  void talkByUrbiSend(String where) throws Exception {
    String first = outputOf(SEND, where, "-e", "UMachine.assemble([12, 34]);", "--quit");
    assertTrue(first.endsWith("[] \"1234\""), first);
    String second =
        outputOf(
            SEND,
            where,
            "-e",
            "var f = UMachine.new(10ms)|",
            "-e",
            "f.assemble([\"ab\", \"cd\"]);",
            "--quit");
    assertTrue(second.endsWith("[] \"abcd\""), second);
  }

  /** Without what may differ between two good runs. */
  static String plain(String text) {
    return text.replaceAll("(?m)^\\[\\d{8,}", "[").replaceAll("0x[0-9a-f]+", "0x");
  }
}
