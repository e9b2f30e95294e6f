package org.urbi.kernel;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Pattern;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.compile.Compilation;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.ProblemKind;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobState;
import org.urbi.kernel.job.TagStop;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.library.Library;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.World;
import org.urbi.kernel.trust.Role;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.UrbiParser;
import org.urbi.lang.source.Span;

/** A fresh kernel that makes wrong calls, each in a job of its own, and judges what comes of it. */
final class WrongCallKernel implements AutoCloseable {
  /** Simulated: as long as anything may wait. */
  private static final long VIRTUAL_TIMEOUT = TimeUnit.HOURS.toNanos(30);

  /** Real: how long somebody waits before he looks. */
  private static final long WAIT_MS = 40;

  /** After so many waits a call is ended as the user may end what never lets others run. */
  private static final int WAITS_TO_INTERRUPT = 2;

  /**
   * After so many waits the kernel hangs. They are counted, and no clock is read: the whole process
   * may be stopped for a while.
   */
  private static final int WAITS_TO_GIVE_UP = 1_500;

  private static final int TURNS_TO_END = 50;

  /**
   * What only Java says, each with a word that is in it: looking for the word takes a tenth of the
   * time.
   */
  private static final Map<String, Pattern> JAVA =
      Map.of(
          "java", Pattern.compile("javax?\\."),
          "org.urbi.", Pattern.compile("org\\.urbi\\."),
          "jdk.", Pattern.compile("jdk\\."),
          "\tat ", Pattern.compile("\\tat "),
          "internal error", Pattern.compile("internal error"),
          "Exception", Pattern.compile("Exception in thread|\\b[A-Z]\\w+Exception\\b"),
          "Error", Pattern.compile("(?!Key)[A-Z]\\w+Error\\b"),
          "@", Pattern.compile("@[0-9a-f]{6,}"));

  /** What came of a call. */
  enum Result {
    VALUE,
    EXCEPTION,
    /** It still waited when nobody wanted to know any more. */
    ENDED,
    /** The kernel is no longer what it was: calls may do that. */
    SPOILT,
    /** It would say nothing new, and is not made. */
    KNOWN
  }

  /** A call that has not been answered as it should. */
  static final class Defect extends RuntimeException {
    private final boolean certain;

    Defect(String message) {
      this(message, false);
    }

    Defect(String message, boolean certain) {
      super(message);
      this.certain = certain;
    }

    /** Whether it is one whatever calls there were before. */
    boolean isCertain() {
      return certain;
    }
  }

  /**
   * How a call was answered.
   *
   * @param text that of the exception; null when there was none
   * @param isOfDeclaration whether the declaration has refused a value, and no code was executed
   */
  record Answer(Result result, String text, boolean isOfDeclaration) {}

  /** Sees who asks for its name: the generated table does so to refuse what was not declared. */
  private static final class Site implements CallSite {
    private static final StackWalker WALKER =
        StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE);

    private final String name;
    private boolean askedByDeclaration;

    Site(String name) {
      this.name = name;
    }

    @Override
    public String calledName() {
      askedByDeclaration |=
          WALKER
              .walk(frames ->
                  frames
                      .map(StackWalker.StackFrame::getDeclaringClass)
                      .dropWhile(type -> type == Site.class || type == Arguments.class)
                      .findFirst())
              .filter(BuiltinTable.class::isAssignableFrom)
              .isPresent();
      return name;
    }

    @Override
    public Span calledSpan() {
      return null;
    }
  }

  /** The expressions, as every kernel compiles them for itself. */
  private static final Map<String, Ast> PARSED = new ConcurrentHashMap<>();

  private final Kernel kernel;
  private final Interpreter interpreter;
  private final Map<String, Compilation.Compiled> compiled = new LinkedHashMap<>();

  /**
   * The functions of the library as this kernel has them; calls may remove them from their types.
   */
  private final Map<String, Code> primitives = new HashMap<>();

  private final StringBuffer heard = new StringBuffer();
  private UrbiLobby lobby;
  private volatile Job judge;
  private volatile WrongCall current;
  private final AtomicInteger waits = new AtomicInteger();

  /** What must be refused before any call is made. */
  private static final List<String> PROBES =
      List.of(
          "Path.new(\"/\").exists",
          "Path.new(\"..\").exists",
          "Directory.new(\"..\")",
          "Process.new(\"missing/program\", []).run",
          "System.system(\"missing/program\")",
          "Socket.new.connect(\"localhost\", 1)",
          "Server.new.listen(\"localhost\", 0)");

  WrongCallKernel(Path directory) {
    kernel =
        Kernel.builder()
            .virtualTime(true)
            .confinedTo(directory)
            .log(heard::append)
            .logLevel(LogLevel.of("DUMP"))
            .onHalt(status -> {})
            .start();
    interpreter = kernel.interpreter();
    within((run, job) -> {
      collectPrimitives();
      checkConfined(top(job), directory);
      evaluate(top(job), WrongValues.PREPARATION);
    });
  }

  private void collectPrimitives() {
    for (BuiltinTable table : Library.declarations()) {
      UrbiObject type = interpreter.world().prototype(table.type());
      for (int i = 0; i < table.size(); i++) {
        Symbol name = interpreter.world().symbol(table.name(i));
        UrbiObject found = table.isSetter(i) ? type.slotData(name).setter() : type.localSlot(name);
        if (found instanceof Code code) {
          primitives.put(nameOf(table, i), code);
        } else {
          throw new Defect("no function: " + nameOf(table, i));
        }
      }
    }
  }

  private static String nameOf(BuiltinTable table, int index) {
    return (table.isSetter(index) ? "set " : "") + table.type() + "." + table.name(index);
  }

  /** Nothing that is called here may do any harm, whatever its arguments are. */
  private void checkConfined(Frame frame, Path directory) {
    UrbiObject working = evaluate(frame, "Path.cwd.asString");
    if (!kernel.isConfined()
        || !(working instanceof UrbiString text)
        || !text.value().equals(directory.toString())) {
      throw new Defect("not confined");
    }
    for (String probe : PROBES) {
      try {
        evaluate(frame, probe);
        throw new Defect("not refused: " + probe);
      } catch (UrbiException e) {
        if (!message(e).matches("(?s).*(of|in) this kernel.*")) {
          throw new Defect("not refused as confined: " + probe + ": " + message(e));
        }
      }
    }
  }

  private String message(UrbiException thrown) {
    return ((UrbiString) thrown.value().lookup(interpreter.world().symbol("message"))).value();
  }

  World world() {
    return interpreter.world();
  }

  Frame top(Job job) {
    return Frame.top(interpreter, job, lobby, new FrameLayout());
  }

  /** What is done in a job of a kernel. */
  interface Task {
    void run(WrongCallKernel kernel, Job job);
  }

  /** Does something in a job, and waits. */
  void within(Task body) {
    CompletableFuture<Void> over = new CompletableFuture<>();
    waits.set(0);
    KernelThread.run(
        kernel,
        () -> {
          if (lobby == null) {
            lobby =
                UrbiLobby.start(
                    interpreter,
                    new Output(kernel.scheduler(), heard::append),
                    new org.urbi.kernel.lobby.Shell.Listener() {
                      @Override
                      public void consumed() {}

                      @Override
                      public void finished() {}
                    },
                    Role.OWNER,
                    new org.urbi.kernel.budget.Budget());
          }
          judge =
              kernel
                  .scheduler()
                  .startDetached(
                      lobby,
                      kernel.scheduler().rootScope(),
                      "judge",
                      job -> {
                        try {
                          body.run(this, job);
                          over.complete(null);
                        } catch (ControlFlowException e) {
                          over.completeExceptionally(e);
                          throw e;
                        } catch (Throwable e) {
                          // Who waits is told; nobody else need be.
                          over.completeExceptionally(e);
                        }
                      });
          judge.onEnd(() ->
              over.completeExceptionally(
                  kernel.isStopping() ? new Ended() : new Defect("the judge was stopped")));
        });
    kernel.onTermination(() -> over.completeExceptionally(new Ended()));
    await(over);
  }

  /** Lets values know of what types they are. */
  void teach(WrongValues values) {
    for (String expression : values.expressions()) {
      within((run, job) -> values.learn(world(), expression, evaluate(top(job), expression)));
    }
  }

  private void await(CompletableFuture<Void> over) {
    while (true) {
      try {
        over.get(WAIT_MS, TimeUnit.MILLISECONDS);
        return;
      } catch (TimeoutException e) {
        hurry(waits.incrementAndGet());
      } catch (java.util.concurrent.ExecutionException e) {
        if (e.getCause() instanceof Defect defect) {
          throw defect;
        }
        if (e.getCause() instanceof Spoilt spoilt) {
          throw spoilt;
        }
        if (e.getCause() instanceof Ended
            || e.getCause() instanceof TagStop && kernel.isStopping()) {
          throw new Ended();
        }
        throw new Defect(
            e.getCause() instanceof UrbiException thrown
                ? "thrown: " + message(thrown)
                : "" + e.getCause() + List.of(e.getCause().getStackTrace()));
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new Defect("interrupted");
      }
    }
  }

  /** Ends what takes long: as others may, as the user may, and else it is a defect. */
  private void hurry(int waited) {
    WrongCall call = current;
    if (waited > WAITS_TO_GIVE_UP) {
      throw new Defect("no end: " + (call == null ? "not even before" : call.source()));
    }
    if (call != null && waited > WAITS_TO_INTERRUPT) {
      kernel.scheduler().interruptions().request(lobby);
    }
    if (call != null) {
      KernelThread.run(kernel, judge::wake);
    }
  }

  // ------------------------------------------------------------------ in jobs

  /** Evaluates an expression. */
  UrbiObject evaluate(Frame frame, String expression) {
    Compilation.Compiled code =
        compiled.computeIfAbsent(
            expression,
            text ->
                Compilation.compile(
                    interpreter, PARSED.computeIfAbsent(text, WrongCallKernel::parse)));
    return code.code().execute(Frame.top(interpreter, frame.job(), frame.self(), code.layout()));
  }

  private static Ast parse(String text) {
    var parsed = UrbiParser.parse(text + ";", null);
    if (!parsed.errors().isEmpty()) {
      throw new Defect(text + ": " + parsed.errors().getFirst().message());
    }
    return parsed.sequence().statements().getFirst();
  }

  /** Makes a call and waits for its end; in the job of the judge. */
  Answer make(Job judge, WrongCall call) {
    current = call;
    waits.set(0);
    Attempt attempt = new Attempt(call);
    Job worker =
        kernel
            .scheduler()
            .startDetached(lobby, kernel.scheduler().rootScope(), "call", attempt::run);
    worker.onEnd(judge::wake);
    Timers.Timer timer =
        kernel.scheduler().timers().add(kernel.scheduler().now() + VIRTUAL_TIMEOUT, judge::wake);
    judge.waitForWake();
    timer.cancel();
    if (worker.state() != JobState.ENDED) {
      worker.terminate();
      for (int i = 0; i < TURNS_TO_END && worker.state() != JobState.ENDED; i++) {
        judge.yieldNow();
      }
      if (worker.state() != JobState.ENDED) {
        throw new Defect("cannot be stopped: " + call.source());
      }
    }
    if (attempt.defect != null) {
      throw new Defect(attempt.defect + ": " + call.source(), attempt.certain);
    }
    checkHeard(call);
    if (attempt.result == Result.SPOILT) {
      throw new Spoilt();
    }
    clear(judge);
    mark(judge);
    return new Answer(attempt.result, attempt.text, attempt.site.askedByDeclaration);
  }

  /** The jobs that calls have left behind. */
  private void clear(Job judge) {
    List<Job> jobs = kernel.scheduler().jobs();
    if (jobs.size() > 1) {
      for (Job job : jobs) {
        if (job != judge) {
          job.terminate();
        }
      }
      judge.yieldNow();
    }
    lobby.connectionTag().state().unblock();
  }

  private void checkHeard(WrongCall call) {
    String text = heard.toString();
    heard.setLength(0);
    if (showsJava(text)) {
      throw new Defect("Java shows in the output: " + shortened(text) + ": " + call.source());
    }
  }

  private void mark(Job judge) {
    UrbiObject three;
    try {
      three = evaluate(top(judge), "1 + 2");
    } catch (UrbiException e) {
      throw new Spoilt();
    }
    if (!(three instanceof UrbiFloat number) || number.value() != 3) {
      throw new Spoilt();
    }
  }

  /** The kernel has ended. */
  static final class Ended extends RuntimeException {}

  /** A call has changed what all objects have in common. */
  static final class Spoilt extends RuntimeException {}

  /** Whether a text is of Java, and not meant for people. */
  static boolean showsJava(String text) {
    for (Map.Entry<String, Pattern> each : JAVA.entrySet()) {
      if (text.contains(each.getKey()) && each.getValue().matcher(text).find()) {
        return true;
      }
    }
    return false;
  }

  private static String shortened(String text) {
    return text.length() < 1000 ? text : text.substring(0, 1000) + "…";
  }

  /** One call. */
  private final class Attempt {
    private final WrongCall call;
    private final Site site;
    private Result result = Result.ENDED;
    private String defect;
    private boolean certain;
    private String text;

    Attempt(WrongCall call) {
      this.call = call;
      site = new Site(call.name());
    }

    void run(Job job) {
      try {
        attempt(job);
      } catch (ControlFlowException e) {
        // Whatever it was that was to be left.
        throw e;
      } catch (UrbiException e) {
        result = Result.SPOILT;
      } catch (StackOverflowError | OutOfMemoryError e) {
        // To who catches it, an Exception.Scheduling.
        result = Result.EXCEPTION;
      } catch (Throwable e) {
        certain = true;
        defect = e + shortened(List.of(e.getStackTrace()).toString());
      }
    }

    private void attempt(Job job) {
      Frame frame = top(job);
      UrbiObject target = evaluate(frame, call.target());
      List<UrbiObject> arguments = new ArrayList<>();
      call.arguments().forEach(argument -> arguments.add(evaluate(frame, argument)));
      Code primitive = primitives.get(nameOf(call.table(), call.index()));
      try {
        UrbiObject value =
            interpreter.call(frame, site, primitive, target, arguments.toArray(UrbiObject[]::new));
        if (value == null) {
          defect = "null";
        } else {
          result = Result.VALUE;
        }
      } catch (UrbiException e) {
        result = Result.EXCEPTION;
        thrown(frame, e.value());
      }
    }

    private void thrown(Frame frame, UrbiObject value) {
      if (!value.isA(interpreter.world().prototype("Exception"))) {
        defect = "not an Exception";
        return;
      }
      UrbiObject shown = interpreter.send(frame, value, "asString");
      text = shown instanceof UrbiString string ? string.value() : null;
      if (text == null || text.isEmpty() || showsJava(text)) {
        defect = "wrong text: " + text;
      } else if (call.hasWrongArity()) {
        String expected =
            Errors.arityText(
                call.name(),
                call.arguments().size(),
                call.table().minArguments(call.index()),
                call.table().maxArguments(call.index()));
        if (!interpreter.errors().is(value, ProblemKind.ARITY) || !text.equals(expected)) {
          defect = "not “" + expected + "” but “" + text + "”";
        }
      }
    }
  }

  @Override
  public void close() {
    kernel.requestShutdown(0);
  }
}
