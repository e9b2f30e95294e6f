package org.urbi.bridge;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;

/**
 * What is typed into a kernel with C++ UObjects, and what it answers: lines that begin with a time
 * stamp. Time stamps do not matter, and {@code NAME} stands for the name of an object.
 */
final class Dialogue {
  private static final Pattern ANSWER = Pattern.compile("^\\[\\d{8,}(:\\w+)?\\] ");
  private static final Pattern OBJECT = Pattern.compile("\\w+_0x[0-9a-f]+");

  private Dialogue() {}

  /** The answers that are expected. */
  static List<String> expected(Path file) throws IOException {
    return answers(Files.readAllLines(file));
  }

  /** What a kernel answers in which modules have been loaded. */
  static List<String> actual(Path file, Path... modules) throws IOException {
    StringBuilder input = new StringBuilder();
    for (String line : Files.readAllLines(file)) {
      if (!ANSWER.matcher(line).find()) {
        input.append(line).append('\n');
      }
    }
    return answers(run(input.toString(), modules).lines().toList());
  }

  private static List<String> answers(List<String> lines) {
    List<String> answers = new ArrayList<>();
    for (String line : lines) {
      var matcher = ANSWER.matcher(line);
      if (matcher.find()) {
        String channel = matcher.group(1) == null ? "" : matcher.group(1).substring(1) + ": ";
        answers.add(OBJECT.matcher(channel + line.substring(matcher.end())).replaceAll("NAME"));
      }
    }
    return answers;
  }

  /** Runs a program on a kernel of its own, in virtual time, and returns what it prints. */
  static String run(String program, Path... modules) {
    StringBuffer log = new StringBuffer();
    List<NativeModule> loaded = new ArrayList<>();
    Output output = new Output();
    try (Kernel kernel =
        Kernel.builder().virtualTime(true).log(line -> log.append(line).append('\n')).start()) {
      for (Path module : modules) {
        NativeModule made = NativeModule.load(module);
        loaded.add(made);
        made.module().startIn(kernel.uobjects());
      }
      Connection connection = kernel.connect(output);
      connection.send(program + "\nsleep(1ms)|;\nshutdown;\n");
      CompletableFuture<Void> ended = CompletableFuture.runAsync(kernel::awaitTermination);
      CompletableFuture.anyOf(ended, output.closed).orTimeout(1, TimeUnit.MINUTES).join();
    }
    loaded.forEach(NativeModule::close);
    return output.text + log.toString();
  }

  private static final class Output implements Client {
    private final StringBuffer text = new StringBuffer();
    private final CompletableFuture<Void> closed = new CompletableFuture<>();

    @Override
    public void output(String bytes) {
      text.append(new String(bytes.getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8));
    }

    @Override
    public void closed() {
      closed.complete(null);
    }
  }
}
