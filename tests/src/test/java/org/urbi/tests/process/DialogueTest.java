package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * The dialogues of {@code examples/uobjects} and {@code examples/uobjects-cpp}, twice: with the
 * modules plugged into a server, and with the same modules in processes of their own. Two servers
 * are enough for all: modules come and go.
 */
class DialogueTest {
  private static final Path DIALOGUES = Modules.SOURCES.resolve("dialogues");

  @TempDir static Path folder;
  private static Modules modules;
  private static final CxxModules CXX_MODULES = new CxxModules();
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

  /** A dialogue, the program that runs its modules remote, and how they are made. */
  private record DialogueCase(Dialogue dialogue, String launcher, Function<String, Path> maker) {
    List<Path> modules() {
      return dialogue.modules().stream().map(maker).toList();
    }
  }

  @TestFactory
  Stream<DynamicTest> everyDialogueIsHeld() throws IOException {
    return tests(DIALOGUES, "UrbiLaunchJava", module -> modules.jar(module));
  }

  @TestFactory
  Stream<DynamicTest> everyDialogueWithCxxIsHeld() throws IOException {
    return tests(CxxModules.SOURCES.resolve("dialogues"), "UrbiLaunch", CXX_MODULES::library);
  }

  @TestFactory
  Stream<DynamicTest> programsOf27Run() throws IOException {
    return tests(CxxModules.OWN, "UrbiLaunch", CXX_MODULES::ownLibrary);
  }

  private static Stream<DynamicTest> tests(
      Path folder, String launcher, Function<String, Path> maker) throws IOException {
    List<DynamicTest> tests = new ArrayList<>();
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file :
          files.filter(file -> file.toString().matches(".*\\.u(-session)?")).sorted().toList()) {
        DialogueCase play =
            new DialogueCase(Dialogue.read(file), "org.urbi.server.launch." + launcher, maker);
        Dialogue dialogue = play.dialogue();
        if (dialogue.plugged()) {
          tests.add(dynamicTest(dialogue.name() + ", plugged", () -> holdPlugged(play)));
        }
        if (dialogue.remote()) {
          tests.add(dynamicTest(dialogue.name() + ", remote", () -> holdRemote(play)));
        }
      }
    }
    assertFalse(tests.isEmpty());
    return tests.stream();
  }

  private static void holdPlugged(DialogueCase play) throws IOException {
    List<Path> files = play.modules();
    try (ConsoleClient manager = plugged.connect()) {
      for (Path file : files) {
        manage(manager, "loadModule", file);
      }
      try (ConsoleClient client = plugged.connect()) {
        play.dialogue().hold(client);
      } finally {
        for (Path file : files) {
          manage(manager, "unloadModule", file);
        }
      }
    }
  }

  private static void manage(ConsoleClient manager, String function, Path file) throws IOException {
    assertEquals(List.of(), manager.answers("%s(\"%s\");".formatted(function, file)));
  }

  private static void holdRemote(DialogueCase play) throws Exception {
    List<String> arguments = new ArrayList<>(List.of("--port", String.valueOf(remote.port())));
    play.modules().forEach(file -> arguments.add(file.toString()));
    try (JavaProcess launch =
        JavaProcess.start(JavaProcess.Setting.in(folder), play.launcher(), arguments)) {
      launch.awaitText("running on 127.0.0.1:" + remote.port());
      try (ConsoleClient client = remote.connect()) {
        play.dialogue().hold(client);
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
