package org.urbi.bridge;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;

/** What is typed into a kernel with C++ UObjects, and what it answers. */
final class Dialogue {
  private Dialogue() {}

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
      CompletableFuture.anyOf(ended, output.closed).join();
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
