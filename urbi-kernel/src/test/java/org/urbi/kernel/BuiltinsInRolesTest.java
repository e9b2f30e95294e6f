package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagStop;
import org.urbi.kernel.library.Library;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.trust.Role;
import org.urbi.lang.source.Span;

/** Every builtin of the library is called in every role, on the prototype of its type. */
class BuiltinsInRolesTest {
  private static final String REFUSED = "needs the role";

  /** They end the connection whose code calls them, and no other: {@link RolesTest} has them. */
  private static final Set<String> ENDINGS = Set.of("Lobby.quit");

  /** What the library itself makes when somebody asks for it first. */
  private static final Set<String> MADE_WHEN_ASKED_FOR =
      Set.of("elementAdded", "elementChanged", "elementRemoved", "levels", "valueCache");

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

  /** What came of each call; nothing of those that wait. */
  private final Map<String, String> outcomes = new TreeMap<>();

  private Kernel kernel;
  private UrbiLobby lobby;

  @ParameterizedTest
  @EnumSource(names = {"USER", "OBSERVER"})
  void everyBuiltinAsksForWhatItDeclares(Role role) {
    try (Kernel started = Kernel.builder().virtualTime(true).log(line -> {}).start()) {
      kernel = started;
      TestClient owner = new TestClient(kernel, Role.OWNER);
      TestClient caller = new TestClient(kernel, role);
      owner.say("sleep(1s);");
      List<String> before = new ArrayList<>();
      KernelThread.run(
          kernel,
          () -> {
            lobby = ((KernelConnection) caller.connection()).lobby();
            before.addAll(systemState());
            Library.declarations().forEach(this::callAll);
          });
      // All that they start has come to rest, and the server is still there.
      owner.say("sleep(10h);");
      CompletableFuture<List<String>> state = new CompletableFuture<>();
      KernelThread.run(kernel, () -> state.complete(systemState()));
      List<String> after = state.join();
      assertEquals(String.join("\n", before), String.join("\n", after));
      List<String> wrong = new ArrayList<>();
      int refused = 0;
      for (BuiltinTable table : Library.declarations()) {
        for (int i = 0; i < table.size(); i++) {
          boolean mustBe = role.compareTo(table.leastRole(i)) < 0 || table.changesTarget(i);
          String outcome = outcomes.getOrDefault(nameOf(table, i), "");
          refused += mustBe ? 1 : 0;
          if (mustBe != outcome.contains(REFUSED)) {
            wrong.add(nameOf(table, i) + ": " + outcome);
          }
        }
      }
      assertEquals(List.of(), wrong);
      assertTrue(refused > 150, "only " + refused);
    }
  }

  private void callAll(BuiltinTable table) {
    Interpreter interpreter = kernel.interpreter();
    UrbiObject type = interpreter.world().prototype(table.type());
    for (int i = 0; i < table.size(); i++) {
      Symbol name = interpreter.world().symbol(table.name(i));
      Code code = (Code) (table.isSetter(i) ? type.slotData(name).setter() : type.localSlot(name));
      String called = nameOf(table, i);
      if (!ENDINGS.contains(called)) {
        kernel
            .scheduler()
            .startDetached(
                lobby,
                kernel.scheduler().rootScope(),
                "call",
                job -> call(job, code, type, called));
      }
    }
  }

  private void call(Job job, Code code, UrbiObject target, String called) {
    Interpreter interpreter = kernel.interpreter();
    Frame frame = Frame.top(interpreter, job, lobby, new FrameLayout());
    try {
      code.call(frame, new Site(called), target);
      outcomes.put(called, "");
    } catch (UrbiException e) {
      UrbiObject message = e.value().lookup(interpreter.world().symbol("message"));
      outcomes.put(called, message instanceof UrbiString text ? text.value() : "");
    } catch (TagStop e) {
      outcomes.put(called, "stopped");
    }
  }

  private static String nameOf(BuiltinTable table, int index) {
    return table.type() + "." + table.name(index) + (table.isSetter(index) ? "=" : "");
  }

  /** The prototypes, their slots and what is in these, in words that tell every change. */
  private List<String> systemState() {
    Map<String, String> state = new LinkedHashMap<>();
    for (BuiltinTable table : Library.declarations()) {
      UrbiObject type = kernel.interpreter().world().prototype(table.type());
      StringBuilder words = new StringBuilder(table.type());
      for (Symbol name : type.localSlotNames()) {
        if (MADE_WHEN_ASKED_FOR.contains(name.name())) {
          continue;
        }
        words.append(' ').append(name.name()).append('@');
        words.append(System.identityHashCode(type.localSlot(name)));
        words.append(type.slotData(name) == null ? "" : type.slotData(name).properties().keySet());
      }
      for (UrbiObject proto : type.protos()) {
        words.append(" :").append(System.identityHashCode(proto));
      }
      state.put(table.type(), words.toString());
    }
    return List.copyOf(state.values());
  }
}
