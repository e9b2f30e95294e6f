package org.urbi.tests.pages;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.urbi.tests.FreePorts;
import org.urbi.tests.LineDifference;
import org.urbi.tests.OutputNormalizer;
import org.urbi.tests.TestTimeout;
import org.urbi.tests.Transcript;
import org.urbi.tests.pages.Listing.Kind;

/**
 * The terminals of a reader, in the folder of a fresh checkout. A line {@code $ COMMAND} is run by
 * a shell. What follows is what it prints; at programs that are interactive, lines without a time
 * stamp are typed. After {@code $ cat FILE} comes the text of the file, which is there then. In
 * what is printed {@code …} stands for anything.
 *
 * <p>Ports that a page names are exchanged for free ones: others use them on the same machine.
 */
final class Terminal implements AutoCloseable {
  private static final String PROMPT = "$ ";
  private static final String ANYTHING = "…";
  private static final String CAT = "cat ";

  /** How a reader leaves a program that a component keeps running. */
  private static final String LEAVE = "shutdown;";

  private static final Pattern INTERACTIVE = Pattern.compile(".* (-i|--interactive)( .*)?");
  private static final Pattern PORT = Pattern.compile("\\b(54000|54080|8642|8080|9090)\\b");

  /** What consoles say first; pages leave it out. */
  private static final Pattern BANNER =
      Pattern.compile(
          "(\\[\\d+] \\*\\*\\* \\*{50,}\n)(\\[\\d+] \\*\\*\\*.*\n)*?(\\[\\d+] \\*\\*\\* \\*{50,}\n)");

  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();

  /** What pages use of a checkout, besides the examples. */
  private static final List<String> LINKED =
      List.of("urbi", "bin", "share", "scripts", "include", ".build");

  private final Path folder;
  private final Map<String, String> ports = new HashMap<>();
  private final List<Running> background = new ArrayList<>();
  private Path current;

  /** A command, and the lines below it. */
  private record Command(String words, List<String> below) {
    boolean isInteractive() {
      return INTERACTIVE.matcher(words).matches();
    }

    boolean makesFile() {
      return words.startsWith(CAT);
    }

    private static boolean isPrinted(String line) {
      return Transcript.isOutput(line) || line.equals(ANYTHING);
    }

    List<String> typed() {
      return isInteractive() ? below.stream().filter(line -> !isPrinted(line)).toList() : List.of();
    }

    List<String> printed() {
      return isInteractive() ? below.stream().filter(Command::isPrinted).toList() : below;
    }
  }

  /** What runs in the background, and its output. */
  private record Running(Command command, Process process, BufferedReader output) {}

  /** Opens them in an empty folder, which becomes like the project's. */
  Terminal(Path folder) throws IOException {
    this.folder = folder;
    current = folder;
    for (String name : LINKED) {
      Files.createSymbolicLink(folder.resolve(name), ROOT.resolve(name));
    }
    // What a reader makes there does not become a part of the project.
    Path examples = ROOT.resolve("examples");
    try (Stream<Path> files = Files.walk(examples)) {
      for (Path file : files.toList()) {
        Files.copy(file, folder.resolve(ROOT.relativize(file)));
      }
    }
  }

  /** Does what a listing shows. */
  void hold(Listing listing) throws IOException {
    if (listing.kind() == Kind.FILE) {
      Files.writeString(current.resolve(listing.detail()), listing.text());
      return;
    }
    if (listing.kind() == Kind.MODULE) {
      Files.writeString(current.resolve(JavaListings.fileName(listing)), listing.text());
      return;
    }
    int before = background.size();
    for (Command command : commands(listing)) {
      if (command.makesFile()) {
        Files.write(current.resolve(command.words().substring(CAT.length())), command.below());
      }
      hold(command, listing.kind() == Kind.BACKGROUND);
    }
    for (Running running : background.subList(before, background.size())) {
      awaitPrinted(running);
    }
  }

  private static List<Command> commands(Listing listing) {
    List<Command> commands = new ArrayList<>();
    for (String line : listing.lines()) {
      if (line.startsWith(PROMPT)) {
        commands.add(new Command(line.substring(PROMPT.length()), new ArrayList<>()));
      } else if (commands.isEmpty()) {
        throw new IllegalArgumentException("no command, `$ …', before: " + line);
      } else {
        commands.getLast().below().add(line);
      }
    }
    return commands;
  }

  private void hold(Command command, boolean inBackground) throws IOException {
    String words = withFreePorts(command.words());
    if (words.startsWith("cd ")) {
      current = current.resolve(words.substring("cd ".length())).normalize();
      return;
    }
    boolean goesOn = inBackground || words.endsWith("&");
    Path typed = Files.createTempFile(folder, "typed", ".txt");
    List<String> lines =
        new ArrayList<>(command.typed().stream().map(this::withFreePorts).toList());
    if (!goesOn && command.isInteractive()) {
      lines.add(LEAVE);
    }
    Files.write(typed, lines);
    Process process =
        builder(goesOn ? words.replaceFirst("&$", "") : words)
            .redirectInput(typed.toFile())
            .start();
    AtomicBoolean late = new AtomicBoolean();
    endWhenLate(process, late);
    if (goesOn) {
      background.add(new Running(command, process, process.inputReader(StandardCharsets.UTF_8)));
    } else {
      String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      if (late.get()) {
        throw new AssertionError(words + " does not end: " + output);
      }
      compare(command, output);
    }
  }

  /** Waits until it has said what the page shows. */
  private void awaitPrinted(Running running) throws IOException {
    List<String> missing = new ArrayList<>(running.command().printed());
    while (!missing.isEmpty()) {
      String line = running.output().readLine();
      if (line == null) {
        throw new AssertionError(running.command().words() + " does not say " + missing);
      }
      missing.remove(withPortsOfPage(line));
    }
  }

  /** What does not end is ended, so that what it has printed can be told. */
  private static void endWhenLate(Process process, AtomicBoolean late) {
    CompletableFuture.delayedExecutor(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS)
        .execute(() -> {
          late.set(process.isAlive());
          end(process);
        });
  }

  /** Ends the shell and what it has started. */
  private static void end(Process process) {
    process.descendants().forEach(ProcessHandle::destroyForcibly);
    process.destroyForcibly();
  }

  private ProcessBuilder builder(String words) {
    ProcessBuilder builder =
        new ProcessBuilder("/bin/sh", "-c", words)
            .directory(current.toFile())
            .redirectErrorStream(true);
    builder.environment().keySet().removeIf(variable -> variable.startsWith("URBI_"));
    // What umake compiles for many components pays from the second one on, and a page has one.
    builder.environment().put("URBI_UMAKE_KEPT", "");
    builder
        .environment()
        .merge(
            "PATH",
            folder + ":" + folder.resolve("bin") + ":" + System.getProperty("java.home") + "/bin",
            (old, own) -> own + ":" + old);
    return builder;
  }

  private void compare(Command command, String output) {
    List<String> expected = comparable(command.printed());
    String shown = withPortsOfPage(output);
    if (!String.join("\n", expected).contains("Urbi version")) {
      shown = BANNER.matcher(shown).replaceFirst("");
    }
    List<String> printed = comparable(shown.lines().toList());
    String pattern =
        expected.stream()
            .map(line -> Pattern.quote(line).replace(ANYTHING, "\\E.*\\Q"))
            .collect(Collectors.joining("\n"));
    if (!Pattern.compile(pattern, Pattern.DOTALL).matcher(String.join("\n", printed)).matches()) {
      throw new AssertionError(command.words() + "\n" + LineDifference.of(expected, printed));
    }
  }

  /** Time stamps do not count: these programs live in our time. */
  private static List<String> comparable(List<String> lines) {
    List<String> result = new ArrayList<>();
    for (String line : lines) {
      result.addAll(
          Transcript.isOutput(line)
              ? OutputNormalizer.comparable(List.of(line), false, true)
              : List.of(line.stripTrailing()));
    }
    return result;
  }

  private String withFreePorts(String text) {
    return PORT.matcher(text)
        .replaceAll(port -> ports.computeIfAbsent(port.group(), Terminal::free));
  }

  private String withPortsOfPage(String text) {
    String result = text;
    for (Map.Entry<String, String> port : ports.entrySet()) {
      result = result.replace(port.getValue(), port.getKey());
    }
    return result;
  }

  private static String free(String port) {
    try {
      return String.valueOf(FreePorts.next());
    } catch (IOException e) {
      throw new UncheckedIOException("instead of port " + port, e);
    }
  }

  /** Ends what still runs, and takes the links away: what they lead to is not ours to delete. */
  @Override
  public void close() throws IOException {
    for (String name : LINKED) {
      Files.delete(folder.resolve(name));
    }
    for (Running running : background) {
      end(running.process());
    }
  }
}
