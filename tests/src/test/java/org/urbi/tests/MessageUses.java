package org.urbi.tests;

import static java.util.Map.entry;

import java.io.IOException;
import java.io.InputStream;
import java.lang.classfile.ClassFile;
import java.lang.classfile.ClassModel;
import java.lang.classfile.CodeElement;
import java.lang.classfile.Instruction;
import java.lang.classfile.Label;
import java.lang.classfile.MethodModel;
import java.lang.classfile.Opcode;
import java.lang.classfile.constantpool.StringEntry;
import java.lang.classfile.instruction.BranchInstruction;
import java.lang.classfile.instruction.ConstantInstruction;
import java.lang.classfile.instruction.FieldInstruction;
import java.lang.classfile.instruction.InvokeDynamicInstruction;
import java.lang.classfile.instruction.InvokeInstruction;
import java.lang.classfile.instruction.LabelTarget;
import java.lang.classfile.instruction.NewReferenceArrayInstruction;
import java.lang.classfile.instruction.ReturnInstruction;
import java.lang.constant.ConstantDesc;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.urbi.kernel.error.HelpText;
import org.urbi.kernel.error.Hint;
import org.urbi.kernel.error.Problem;
import org.urbi.lang.problem.SyntaxHint;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.problem.Template;

/** Where compiled classes use the messages of the catalogues, and where they bypass them. */
final class MessageUses {
  private static final Map<String, Class<? extends Enum<?>>> CATALOGUES =
      Map.of(
          internal(Problem.class),
          Problem.class,
          internal(SyntaxProblem.class),
          SyntaxProblem.class,
          internal(Hint.class),
          Hint.class,
          internal(HelpText.class),
          HelpText.class,
          internal(SyntaxHint.class),
          SyntaxHint.class);

  /** Two words. */
  private static final Pattern SENTENCE = Pattern.compile("\\p{L}{2,},? \\p{L}{2,}");

  /** Exceptions of Java whose messages urbiscript is told. */
  private static final Set<String> TOLD =
      Set.of(
          "java/io/IOException",
          "java/lang/IllegalArgumentException",
          "java/lang/IllegalStateException",
          "urbi/UCastException",
          "urbi/spi/UModuleException",
          "urbi/wire/WireException",
          "org/urbi/kernel/uobject/ConversionFailure");

  private static final String EMBEDS = "told to the Java program that embeds the kernel";
  private static final String DEFECT = "only a defect of ours is told so, in the log";

  /** Classes whose exceptions of Java no user of urbiscript sees, and why. */
  private static final Map<String, String> EXCUSED =
      Map.ofEntries(
          entry("org/urbi/kernel/embed/Embedding", EMBEDS),
          entry("org/urbi/kernel/embed/ListenerQueue", EMBEDS),
          entry("org/urbi/kernel/embed/ToJavaConverter", EMBEDS),
          entry("org/urbi/kernel/embed/UrbiValue", EMBEDS),
          entry("org/urbi/kernel/script/InterfaceProxy", EMBEDS),
          entry("org/urbi/kernel/script/SlotBindings", EMBEDS),
          entry("org/urbi/kernel/script/UrbiScriptEngine", EMBEDS),
          entry("org/urbi/kernel/job/TickLoopThread$Factory", "told to who starts the kernel"),
          entry("org/urbi/kernel/job/TickLoopThread", DEFECT),
          entry("org/urbi/kernel/error/Errors", DEFECT),
          entry("org/urbi/lang/input/StatementReader", DEFECT),
          entry("org/urbi/lang/problem/Template", DEFECT));

  /** The name of a type in urbiscript. */
  private static final Pattern TYPE = Pattern.compile("[A-Z]\\w*");

  /** Who fills exceptions, and tells lobbies of errors and warnings. */
  private static final Set<String> TELLERS =
      Set.of("org/urbi/kernel/lobby/Diagnostics", "org/urbi/kernel/error/Errors$Builder");

  private static final String THROWN = "org/urbi/kernel/error/UrbiException";

  /** Exceptions are made of messages, and by the statement {@code throw}. */
  private static final Pattern MAY_THROW =
      Pattern.compile("org/urbi/kernel/error/.*|org/urbi/kernel/node/Jumps.*");

  /** Who marks errors: for lobbies, for clients without one, in code, and in what a server says. */
  private static final Set<String> MARK_OWNERS =
      Set.of(
          "org/urbi/kernel/lobby/Diagnostics",
          "org/urbi/server/net/ErrorLine",
          "org/urbi/server/cli/LocalConsole",
          "org/urbi/server/launch/PluginRequest");

  /** What talks to other processes, or of them: whatever it says may reach urbiscript. */
  private static final Pattern SPEAKING =
      Pattern.compile("org/urbi/(kernel/remote|server/net|server/isolated)/.*");

  /** Whom only the log, or who starts the server, is told something by. */
  private static final Set<String> LISTENING =
      Set.of(
          "java/io/IOException",
          "java/lang/IllegalStateException",
          "java/util/Objects",
          "org/urbi/kernel/Connection",
          "org/urbi/kernel/log/Defects",
          "org/urbi/kernel/log/FailureLog",
          "org/urbi/kernel/log/WatchFailure",
          "org/urbi/server/Trace",
          "urbi/thread/GuardedThreads");

  private static final String STARTS = "told to who starts the server";
  private static final String LOGGED = "for the log of the server";

  /** Of these classes what no other process is told either, and why. */
  private static final Map<String, String> SPEAKING_EXCUSED =
      Map.of(
          "org/urbi/server/net/ConsoleServer", STARTS,
          "org/urbi/server/net/UnixSocketFile", STARTS,
          "org/urbi/server/net/ForeignProtocolFilter", "the names of protocols",
          "org/urbi/server/net/UnixChannel$1", LOGGED,
          "org/urbi/server/net/TlsGate", LOGGED);

  private final List<String> literals = new ArrayList<>();
  private final Set<String> excused = new HashSet<>();
  private final List<String> misfilled = new ArrayList<>();
  private final List<String> thrownTexts = new ArrayList<>();
  private final Set<Enum<?>> used = new HashSet<>();
  private int filled;

  /** Whether exceptions of Java are told to urbiscript, as they are by the kernel. */
  private boolean tellsExceptions = true;

  private boolean speaks;

  /** Texts that stand in the code: class and text. */
  List<String> literals() {
    return literals;
  }

  /** Classes that are excused for nothing. */
  Set<String> excusedInVain() {
    var none = new TreeSet<>(EXCUSED.keySet());
    none.addAll(SPEAKING_EXCUSED.keySet());
    none.removeAll(excused);
    return none;
  }

  /** Messages that are given more or fewer values than they have places. */
  List<String> misfilled() {
    return misfilled;
  }

  /** Messages that are thrown and are no exceptions. */
  List<String> thrownTexts() {
    return thrownTexts;
  }

  Set<Enum<?>> used() {
    return used;
  }

  /** How many messages were found with their values. */
  int filled() {
    return filled;
  }

  private static String internal(Class<?> type) {
    return type.getName().replace('.', '/');
  }

  /** Reads all classes that stand in the same directory or archive. */
  void readModuleOf(Class<?> type) throws IOException {
    try {
      Path place = Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
      if (Files.isDirectory(place)) {
        readAll(place);
      } else {
        try (FileSystem archive =
            FileSystems.newFileSystem(URI.create("jar:" + place.toUri()), Map.of())) {
          readAll(archive.getPath("/"));
        }
      }
    } catch (URISyntaxException e) {
      throw new IOException(e);
    }
  }

  /** The same of a module around the kernel, whose exceptions urbiscript is not told. */
  void readAround(Class<?> type) throws IOException {
    tellsExceptions = false;
    readModuleOf(type);
    tellsExceptions = true;
  }

  private void readAll(Path root) throws IOException {
    try (Stream<Path> files = Files.walk(root)) {
      for (Path file : files.filter(f -> f.toString().endsWith(".class")).toList()) {
        read(Files.readAllBytes(file));
      }
    }
  }

  /** Reads a class. */
  void read(Class<?> type) throws IOException {
    try (InputStream in = type.getResourceAsStream("/" + internal(type) + ".class")) {
      read(in.readAllBytes());
    }
  }

  /** Reads a class that talks to other processes. */
  void readSpeaker(Class<?> type) throws IOException {
    speaks = true;
    read(type);
    speaks = false;
  }

  private void read(byte[] bytes) {
    ClassModel model = ClassFile.of().parse(bytes);
    String name = model.thisClass().asInternalName();
    if (CATALOGUES.containsKey(name)) {
      return;
    }
    for (MethodModel method : model.methods()) {
      method.code().ifPresent(code -> read(name, code.elementList()));
    }
  }

  private void read(String owner, List<CodeElement> all) {
    List<CodeElement> code =
        all.stream().filter(e -> e instanceof Instruction || e instanceof LabelTarget).toList();
    for (int i = 0; i < code.size(); i++) {
      switch (code.get(i)) {
        case FieldInstruction field when CATALOGUES.containsKey(field.owner().asInternalName()) ->
            message(owner, code, i, field);
        case InvokeInstruction call when TELLERS.contains(call.owner().asInternalName()) ->
            told(owner, code, i);
        case InvokeInstruction call
            when call.name().equalsString("<init>")
                && call.owner().asInternalName().equals(THROWN)
                && !MAY_THROW.matcher(owner).matches() ->
            literals.add(owner + ": an exception of urbiscript that is no message");
        case InvokeInstruction call
            when tellsExceptions
                && call.name().equalsString("<init>")
                && TOLD.contains(call.owner().asInternalName()) ->
            message(owner, code, i);
        default -> {
          String text = text(code.get(i));
          if (text != null && text.contains("!!!") && !MARK_OWNERS.contains(owner)) {
            literals.add(owner + ": " + text);
          }
          if (text != null
              && (speaks || SPEAKING.matcher(owner).matches())
              && SENTENCE.matcher(text).find()
              && !isForLog(code, i)) {
            said(owner, text);
          }
        }
      }
    }
  }

  private void said(String owner, String text) {
    if (SPEAKING_EXCUSED.containsKey(owner)) {
      excused.add(owner);
    } else {
      literals.add(owner + ": " + text + ", said to others");
    }
  }

  /** Whether whoever takes a text is a log, or the failure of whoever starts the server. */
  private static boolean isForLog(List<CodeElement> code, int at) {
    for (CodeElement element : code.subList(at + 1, code.size())) {
      switch (element) {
        case InvokeInstruction call -> {
          return LISTENING.contains(call.owner().asInternalName());
        }
        case ReturnInstruction returned -> {
          return false;
        }
        case FieldInstruction field when field.opcode() == Opcode.PUTFIELD -> {
          return false;
        }
        default -> {}
      }
    }
    return false;
  }

  /** A message, and what is done with it up to the call that takes it. */
  private void message(String owner, List<CodeElement> code, int at, FieldInstruction field) {
    Enum<?> message = constant(field);
    if (message == null) {
      return;
    }
    used.add(message);
    int next = afterJumps(code, at + 1);
    if (code.get(next) instanceof ConstantInstruction count
        && code.get(next + 1) instanceof NewReferenceArrayInstruction) {
      filled++;
      int places = template(message).places().size();
      if (!count.constantValue().equals(places)) {
        misfilled.add(owner + ": " + message + " has " + places + " places");
      }
    }
    for (int i = at + 1; i < code.size(); i++) {
      String text = text(code.get(i));
      if (text != null && SENTENCE.matcher(text).find()) {
        literals.add(owner + ": " + text + ", in " + message);
      }
      if (code.get(i) instanceof InvokeInstruction call && takes(call, field)) {
        boolean thrown =
            call.type().stringValue().endsWith(")Lorg/urbi/kernel/error/UrbiException;")
                || call.type().stringValue().endsWith("Errors$Builder;");
        boolean wrapped = call.owner().asInternalName().endsWith("FileAccess");
        if (thrown && !wrapped && message instanceof Problem p && p.kind().type() == null) {
          thrownTexts.add(owner + ": " + message);
        }
        return;
      }
    }
  }

  /** Somebody is told something: it must not be a sentence that stands there. */
  private void told(String owner, List<CodeElement> code, int at) {
    String text = text(code.get(at - 1));
    if (text != null && SENTENCE.matcher(text).find()) {
      literals.add(owner + ": " + text);
    }
  }

  /** An exception of Java is made: its text must not be a literal. */
  private void message(String owner, List<CodeElement> code, int at) {
    List<CodeElement> before =
        code.subList(Math.max(0, at - 3), at).stream()
            .filter(Instruction.class::isInstance)
            .toList();
    for (CodeElement element : before) {
      String text = text(element);
      if (text == null || text.isBlank() || TYPE.matcher(text).matches()) {
        continue;
      }
      if (EXCUSED.containsKey(owner)) {
        excused.add(owner);
      } else {
        literals.add(owner + ": " + text + ", in an exception of Java");
      }
    }
  }

  private static boolean takes(InvokeInstruction call, FieldInstruction field) {
    return call.owner().equals(field.owner())
        || call.type().stringValue().contains(field.type().stringValue());
  }

  /** Where the code goes on behind a value that is one of two. */
  private static int afterJumps(List<CodeElement> code, int from) {
    int at = from;
    while (true) {
      switch (code.get(at)) {
        case LabelTarget label -> at++;
        case BranchInstruction jump when isGoto(jump) -> at = position(code, jump.target());
        default -> {
          return at;
        }
      }
    }
  }

  private static boolean isGoto(BranchInstruction jump) {
    return jump.opcode().name().startsWith("GOTO");
  }

  private static int position(List<CodeElement> code, Label target) {
    int at = 0;
    while (!(code.get(at) instanceof LabelTarget label && label.label().equals(target))) {
      at++;
    }
    return at;
  }

  private static Enum<?> constant(FieldInstruction field) {
    Class<? extends Enum<?>> catalogue = CATALOGUES.get(field.owner().asInternalName());
    return Stream.of(catalogue.getEnumConstants())
        .filter(each -> field.name().equalsString(each.name()))
        .findAny()
        .orElse(null);
  }

  private static Template template(Enum<?> message) {
    return switch (message) {
      case Problem problem -> problem.template();
      case Hint hint -> hint.template();
      case HelpText text -> text.template();
      case SyntaxHint hint -> hint.template();
      default -> ((SyntaxProblem) message).template();
    };
  }

  /** The text of a literal, or of what a text is put together from; null for all else. */
  private static String text(CodeElement element) {
    return switch (element) {
      case ConstantInstruction.LoadConstantInstruction constant
          when constant.constantEntry() instanceof StringEntry string ->
          string.stringValue();
      case InvokeDynamicInstruction joined
          when joined.name().equalsString("makeConcatWithConstants") -> {
        ConstantDesc recipe = joined.bootstrapArgs().getFirst();
        yield recipe.toString().replace('\1', ' ').replace('\2', ' ');
      }
      default -> null;
    };
  }
}
