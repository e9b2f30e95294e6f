package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.library.Library;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.trust.Role;
import org.urbi.lang.source.Span;

/**
 * Every builtin is called by a user and by an observer on what belongs to an owner, and on objects
 * of their own, with what belongs to the owner as arguments, whose types are learnt from the
 * answers. Nothing of the owner's has changed then, neither its slots nor what it holds.
 */
class BuiltinsOnForeignObjectsTest {
  /** They end the connection whose code calls them, and no other: {@link RolesTest} has them. */
  private static final Set<String> ENDINGS = Set.of("Lobby.quit");

  /** Objects that have been used, and hold what came of it. */
  private static final List<String> USED =
      List.of(
          "{ var re = Regexp.new(\"a(b)?\") | re.match(\"ab\") | re }",
          "{ var pattern = Pattern.new([1]) | pattern.match([1]) | pattern }",
          "{ var news = PubSub.new | news.subscribe | news }",
          "{ var news = PubSub.new | var reader = news.subscribe | news.publish(1) | reader }",
          "Lazy.new(function () { 1 })",
          "{ var tag = Tag.new(\"used\") | tag.setPriority(1) | tag }",
          "Subscription.new(function () { 1 })",
          "UConnection.new(UVar.new(Object.new, \"x\"), UVar.new(Object.new, \"y\"))");

  /** They live by themselves, or need a file: what they hold changes, or there is none. */
  private static final Pattern UNSTEADY =
      Pattern.compile(
          "File|Directory|Path|Stream|Process|Socket|Server|IoService|lobby|Lobby|spawn|Job|"
              + "Finalizable|profile|wrongCall|trigger");

  /** Who listens, or waits, which everybody may; what is made when somebody asks first; a name. */
  private static final Set<String> OPEN =
      Set.of(
          "elementAdded",
          "elementChanged",
          "elementRemoved",
          "enter",
          "leave",
          "changed",
          "subscriptions",
          "subscribed",
          "guests",
          "known",
          "departures",
          "waiting",
          "queue",
          "onChange",
          "onChangeOwned",
          "onAccess",
          "onRtp",
          "lastId",
          "lobby",
          "connections",
          "readers",
          "accessLoop",
          "inputPort");

  private static final Pattern EXPECTED =
      Pattern.compile("argument (\\d+): unexpected .*, expected an? ([\\w.]+)", Pattern.DOTALL);

  /** So often another type may be learnt from an answer. */
  private static final int LESSONS = 6;

  private record Site(String calledName) implements CallSite {
    @Override
    public Span calledSpan() {
      return null;
    }

    @Override
    public Node[] argumentNodes() {
      return new Node[0];
    }
  }

  private final Map<String, List<UrbiObject>> foreign = new LinkedHashMap<>();
  private final List<UrbiObject> all = new ArrayList<>();
  private int answered;
  private int refused;

  private Kernel kernel;
  private UrbiLobby visitor;

  @ParameterizedTest
  @EnumSource(names = {"USER", "OBSERVER"})
  void nothingOfAnOwnersChanges(Role role) {
    try (Kernel started = Kernel.builder().virtualTime(true).log(line -> {}).start()) {
      kernel = started;
      TestClient owner = new TestClient(kernel, Role.OWNER);
      TestClient caller = new TestClient(kernel, role);
      StringBuilder making = new StringBuilder("var Global.foreign = []|;\n");
      List<String> expressions = new ArrayList<>(new WrongValues().expressions());
      expressions.addAll(USED);
      for (String expression : expressions) {
        if (!UNSTEADY.matcher(expression).find() && !isType(expression)) {
          making.append("try { foreign << (" + expression + ") } catch {};\n");
        }
      }
      owner.say(making.toString());
      List<String> before = states(() -> prepare(owner, caller));
      KernelThread.run(kernel, this::callAll);
      owner.say("sleep(10s);");
      List<String> after = states(() -> {});
      List<String> changed = new ArrayList<>();
      for (int i = 0; i < before.size(); i++) {
        if (!before.get(i).equals(after.get(i))) {
          changed.add("\n" + before.get(i) + "\nhas become\n" + after.get(i));
        }
      }
      assertEquals(List.of(), changed);
      assertTrue(answered > 2_000, "only " + answered);
      assertTrue(refused > 300, "only " + refused);
    }
  }

  private static boolean isType(String expression) {
    return Library.declarations().stream().anyMatch(table -> table.type().equals(expression));
  }

  private List<String> states(Runnable first) {
    CompletableFuture<List<String>> states = new CompletableFuture<>();
    KernelThread.run(
        kernel,
        () -> {
          first.run();
          states.complete(all.stream().map(each -> state(each, 2)).toList());
        });
    return states.join();
  }

  private void prepare(TestClient owner, TestClient caller) {
    visitor = ((KernelConnection) caller.connection()).lobby();
    UrbiLobby owners = ((KernelConnection) owner.connection()).lobby();
    World world = kernel.interpreter().world();
    var made = (UrbiList) world.prototype("Global").localSlot(world.symbol("foreign"));
    for (UrbiObject each : List.copyOf(made.elements())) {
      if (each.ownerLobby() == null) {
        each.setOwnerLobby(owners);
      }
      all.add(each);
      for (BuiltinTable table : Library.declarations()) {
        UrbiObject type = world.prototype(table.type());
        if (type != null && each.isA(type)) {
          foreign.computeIfAbsent(table.type(), name -> new ArrayList<>()).add(each);
        }
      }
    }
  }

  // ------------------------------------------------------------------ calls

  private void callAll() {
    World world = kernel.interpreter().world();
    for (BuiltinTable table : Library.declarations()) {
      UrbiObject type = world.prototype(table.type());
      for (int i = 0; i < table.size(); i++) {
        Symbol name = world.symbol(table.name(i));
        String called = table.type() + "." + table.name(i);
        UrbiObject code = table.isSetter(i) ? type.slotData(name).setter() : type.localSlot(name);
        if (ENDINGS.contains(called) || table.isLazy(i) || !(code instanceof Code builtin)) {
          continue;
        }
        List<UrbiObject> targets = foreign.getOrDefault(table.type(), List.of());
        int most = Math.min(table.maxArguments(i), table.minArguments(i) + 1);
        for (int count = table.minArguments(i); count <= most; count++) {
          int arguments = count;
          for (UrbiObject target : targets.subList(0, Math.min(targets.size(), 2))) {
            start(job -> call(job, builtin, target, called, arguments));
          }
          start(job -> call(job, builtin, own(job, type), called, arguments));
        }
      }
    }
  }

  private void start(Job.Body body) {
    kernel.scheduler().startDetached(visitor, kernel.scheduler().rootScope(), "call", body);
  }

  /** An object of the visitor's own; the type itself if there can be none. */
  private UrbiObject own(Job job, UrbiObject type) {
    try {
      return kernel.interpreter().send(top(job), type, "clone");
    } catch (UrbiException e) {
      return type;
    }
  }

  private Frame top(Job job) {
    return Frame.top(kernel.interpreter(), job, visitor, new FrameLayout());
  }

  private void call(Job job, Code code, UrbiObject target, String called, int count) {
    Interpreter interpreter = kernel.interpreter();
    UrbiObject[] arguments = new UrbiObject[count];
    Arrays.fill(arguments, all.get(1));
    for (int lesson = 0; lesson < LESSONS; lesson++) {
      answered++;
      try {
        code.call(top(job), new Site(called), target, arguments);
        return;
      } catch (UrbiException e) {
        // A message that shows values is made when somebody catches it.
        String text = interpreter.asString(top(job), e.value());
        refused += text.contains("needs the role") ? 1 : 0;
        Matcher expected = EXPECTED.matcher(text);
        int place = expected.find() ? Integer.parseInt(expected.group(1)) - 1 : count;
        if (place >= count) {
          return;
        }
        List<UrbiObject> fitting = foreign.getOrDefault(expected.group(2), List.of());
        if (fitting.isEmpty() || fitting.contains(arguments[place])) {
          return;
        }
        arguments[place] = fitting.get(lesson % fitting.size());
      }
    }
  }

  // ------------------------------------------------------------------ states

  private static String state(UrbiObject object, int depth) {
    StringBuilder words = new StringBuilder(name(object));
    Set<String> slots = new TreeSet<>();
    for (Symbol slot : object.localSlotNames()) {
      if (!OPEN.contains(slot.name())) {
        slots.add(
            slot.name()
                + "="
                + value(object.localSlot(slot), 0)
                + (object.slotData(slot) == null
                    ? ""
                    : object.slotData(slot).properties().keySet()));
      }
    }
    words.append(slots);
    for (UrbiObject proto : object.protos()) {
      words.append(" :").append(name(proto));
    }
    fields(object, UrbiObject.class, depth, words);
    return words.toString();
  }

  private static void fields(Object of, Class<?> until, int depth, StringBuilder words) {
    for (Class<?> type = of.getClass(); type != until; type = type.getSuperclass()) {
      for (Field field : type.getDeclaredFields()) {
        if (!Modifier.isStatic(field.getModifiers()) && !OPEN.contains(field.getName())) {
          try {
            field.setAccessible(true);
            words.append(' ').append(field.getName()).append('=');
            words.append(value(field.get(of), depth));
          } catch (IllegalAccessException e) {
            throw new AssertionError(e);
          }
        }
      }
    }
  }

  private static String value(Object value, int depth) {
    if (value == null
        || value instanceof Number
        || value instanceof Boolean
        || value instanceof CharSequence
        || value instanceof Enum<?>) {
      return String.valueOf(value);
    }
    if (value instanceof UrbiList list) {
      return name(list) + list.elements().size();
    }
    if (value instanceof Collection<?> many) {
      return many.stream().map(each -> value(each, 0)).toList().toString();
    }
    if (value instanceof Map<?, ?> map) {
      return value(map.keySet(), 0) + value(map.values(), 0);
    }
    if (value.getClass().isArray()) {
      StringBuilder words = new StringBuilder("[");
      for (int i = 0; i < Array.getLength(value); i++) {
        words.append(value(Array.get(value, i), 0)).append(' ');
      }
      return words + "]";
    }
    StringBuilder words = new StringBuilder(name(value));
    if (depth > 1
        && !(value instanceof UrbiObject)
        && value.getClass().getName().startsWith("org.urbi.kernel.")) {
      words.append('{');
      fields(value, Object.class, depth - 1, words);
      words.append('}');
    }
    return words.toString();
  }

  private static String name(Object value) {
    return value == null
        ? "null"
        : value.getClass().getSimpleName() + "@" + System.identityHashCode(value);
  }
}
