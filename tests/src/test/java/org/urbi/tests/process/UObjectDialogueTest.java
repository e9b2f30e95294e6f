package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * The dialogues of {@code examples/uobjects}, twice: with the modules plugged into a server, and
 * with the modules in processes of their own. Two servers are enough for all: modules come and go.
 */
class UObjectDialogueTest {
  private static final Path DIALOGUES = Modules.SOURCES.resolve("dialogues");

  @TempDir static Path folder;
  private static Modules modules;
  private static ServerProcess plugged;
  private static ServerProcess remote;

  /** How many slots {@code uobjects} has while there is no UObject. */
  private static int ownSlots;

  @BeforeAll
  static void start() throws Exception {
    modules = new Modules(folder);
    plugged = ServerProcess.in(Modules.SOURCES);
    remote = ServerProcess.in(Modules.SOURCES);
    try (ConsoleClient client = remote.connect()) {
      String answer = client.answers("uobjects.localSlotNames.size;").getFirst();
      ownSlots = Integer.parseInt(answer.replaceFirst(".*] ", ""));
    }
  }

  @AfterAll
  static void end() throws Exception {
    try (ServerProcess one = plugged;
        ServerProcess other = remote) {
      assertEquals(0, one.shutDown(), one::text);
      assertEquals(0, other.shutDown(), other::text);
    }
  }

  @TestFactory
  Stream<DynamicTest> everyDialogueIsHeld() throws IOException {
    List<DynamicTest> tests = new ArrayList<>();
    try (Stream<Path> files = Files.list(DIALOGUES)) {
      for (Path file : files.sorted().toList()) {
        Dialogue dialogue = Dialogue.read(file);
        if (dialogue.plugged()) {
          tests.add(dynamicTest(dialogue.name() + ", plugged", () -> holdPlugged(dialogue)));
        }
        if (dialogue.remote()) {
          tests.add(dynamicTest(dialogue.name() + ", remote", () -> holdRemote(dialogue)));
        }
      }
    }
    assertFalse(tests.isEmpty());
    return tests.stream();
  }

  private static void holdPlugged(Dialogue dialogue) throws IOException {
    try (ConsoleClient manager = plugged.connect()) {
      for (String module : dialogue.modules()) {
        manage(manager, "loadModule", modules.jar(module));
      }
      try (ConsoleClient client = plugged.connect()) {
        dialogue.hold(client);
      }
      for (String module : dialogue.modules()) {
        manage(manager, "unloadModule", modules.jar(module));
      }
    }
  }

  private static void manage(ConsoleClient manager, String function, Path jar) throws IOException {
    assertEquals(List.of(), manager.answers("%s(\"%s\");".formatted(function, jar)));
  }

  private static void holdRemote(Dialogue dialogue) throws Exception {
    List<String> arguments = new ArrayList<>(List.of("--port", String.valueOf(remote.port())));
    dialogue.modules().forEach(module -> arguments.add(modules.jar(module).toString()));
    try (JavaProcess launch =
        JavaProcess.start(
            JavaProcess.Setting.in(folder), "org.urbi.server.launch.UrbiLaunchJava", arguments)) {
      launch.awaitText("running on 127.0.0.1:" + remote.port());
      try (ConsoleClient client = remote.connect()) {
        dialogue.hold(client);
      }
      launch.terminate();
      launch.awaitEnd();
    }
    awaitFarewell();
  }

  /** Waits until the server has noticed that the process has gone. */
  private static void awaitFarewell() throws IOException {
    try (ConsoleClient client = remote.connect()) {
      client.answers("while (uobjects.localSlotNames.size != %d) sleep(5ms);".formatted(ownSlots));
    }
  }
}
