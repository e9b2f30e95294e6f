package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.TestTimeout;

/** Programs of C++ with a main of their own, {@code urbi/umain.hh}, and a real server. */
class CxxProgramsTest {
  private static final String OBJECT =
      """
      #include <atomic>
      #include <cstdio>
      #include <urbi/umain.hh>
      static std::atomic<bool> asked(false);
      class Own : public urbi::UObject
      {
      public:
        Own(const std::string& s) : urbi::UObject(s) { UBindFunctions(Own, twice); }
        int twice(int n) { asked = true; return 2 * n; }
      };
      UStart(Own);
      """;

  /** Without arguments it says why it cannot have an Urbi of its own. */
  private static final String MAIN =
      """
      static int alone(const char* argv[])
      {
        UrbiRoot root("own");
        try
        {
          return urbi::main(1, argv, root, true, true);
        }
        catch (const std::exception& e)
        {
          std::puts(e.what());
          return 0;
        }
      }
      int main(int argc, const char* argv[])
      {
        if (argc == 1)
          return alone(argv);
        std::puts(urbi::isPluginMode() ? "plugged" : "remote");
        if (argc != 3
            || urbi::initialize("localhost", std::atoi(argv[2]), urbi::UClient::URBI_BUFLEN, false)
            || !urbi::getDefaultClient())
          return 1;
        while (!asked)
          usleep(1000);
        usleep(200000); // for the answer to arrive
        std::puts("asked");
        return 0;
      }
      """;

  /** Where the program is that umake has made of {@link #MAIN}. */
  @TempDir static Path made;

  private static Path program;

  @TempDir Path folder;

  @BeforeAll
  static void compile() throws IOException, InterruptedException {
    Path source = Files.writeString(made.resolve("own.cc"), OBJECT + MAIN);
    program = made.resolve("own");
    CxxModules.umake("umake", "program", source, program, "--disable-automain");
  }

  private Path compileByHand(String main) throws IOException, InterruptedException {
    Path source = Files.writeString(folder.resolve("own.cc"), OBJECT + main);
    Path compiled = folder.resolve("own");
    CxxModules.compileProgram("g++", source, compiled, "-std=c++17", "-rdynamic");
    return compiled;
  }

  /** An installation that has the classes of these tests. */
  private Path installation() throws IOException {
    Path tool = folder.resolve("root/bin/urbi-launch");
    Files.createDirectories(tool.getParent());
    String words =
        String.join(
            "' '",
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "--enable-native-access=ALL-UNNAMED",
            "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1",
            "-cp",
            JavaProcess.Setting.in(folder).classPath());
    Files.writeString(
        tool, "#!/bin/sh\n[ $URBI_SHOW_COMMAND ] && printf '%s\\n' '" + words + "'\n");
    assertTrue(tool.toFile().setExecutable(true));
    return folder.resolve("root");
  }

  private CompletableFuture<String> start(Path started, String... arguments) throws IOException {
    List<String> words =
        new ArrayList<>(List.of("env", "URBI_ROOT=" + installation(), started.toString()));
    words.addAll(List.of(arguments));
    // Not on the threads that all tests of this JVM share: they may be busy for long.
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return CxxModules.output(words.toArray(String[]::new));
          } catch (IOException | InterruptedException e) {
            throw new AssertionError(e);
          }
        },
        task -> new Thread(task).start());
  }

  private static String end(CompletableFuture<String> program) throws Exception {
    return program.get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
  }

  private static void ask(ServerProcess server) throws Exception {
    try (ConsoleClient client = server.connect()) {
      client.send("waituntil(isdef(Own)); Own.twice(21);\n");
      String line = client.line();
      while (!line.endsWith("] 42")) {
        line = client.line();
      }
    }
  }

  @Test
  void nothingButItsObjects() throws Exception {
    Path bare = compileByHand("UMAIN();\n");
    try (ServerProcess server = ServerProcess.in(folder)) {
      CompletableFuture<String> running = start(bare, "--port", "" + server.port());
      ask(server);
      assertEquals(0, server.shutDown(), server::text);
      assertTrue(end(running).contains("started Own"));
    }
  }

  @Test
  void programUsesUrbiRoot() throws Exception {
    try (ServerProcess server = ServerProcess.in(folder)) {
      CompletableFuture<String> running = start(program, "--port", "" + server.port());
      ask(server);
      String said = end(running);
      assertTrue(said.contains("remote\n"), said);
      assertTrue(said.endsWith("asked\n"), said);
      assertEquals(0, server.shutDown(), server::text);
    }
  }

  @Test
  void noUrbi() throws Exception {
    String said =
        CxxModules.output("env", "URBI_ROOT=" + folder.resolve("no'where"), program.toString());
    assertTrue(
        said.endsWith(
            "no Urbi in "
                + folder.resolve("no'where")
                + ": set URBI_ROOT to the folder where it is\n"),
        said);
  }

  /** Threads of a component that never end do not disturb the end of a server. */
  @Test
  void threadsThatAreLeft() throws Exception {
    Path source =
        Files.writeString(
            folder.resolve("left.cc"),
            """
            #include <map>
            #include <thread>
            #include <urbi/uobject.hh>
            static std::map<int, std::string> all;
            class Left : public urbi::UObject
            {
            public:
              Left(const std::string& s) : urbi::UObject(s)
              {
                UBindVar(Left, v);
                UBindFunctions(Left, start);
              }
              void start()
              {
                for (int i = 0; i < 4; ++i)
                  std::thread([this, i] { run(i); }).detach();
              }
              void run(int i)
              {
                v = i;
                for (int n = 0;; ++n)
                {
                  static std::mutex lock;
                  std::lock_guard<std::mutex> guard(lock);
                  all[n % 100] = std::string(100, 'x');
                }
              }
              urbi::UVar v;
            };
            UStart(Left);
            """);
    Path library = folder.resolve("left.so");
    CxxModules.umake("umake-shared", "library", source, library);
    try (JavaProcess server =
        JavaProcess.start(
            JavaProcess.Setting.in(folder),
            "org.urbi.server.cli.UrbiCommand",
            List.of(
                "-m",
                library.toString(),
                "-e",
                "Left.start|; waituntil(!Left.v.isVoid)|; sleep(200ms)|; shutdown;"))) {
      assertEquals(0, server.awaitEnd(), server::text);
    }
  }
}
