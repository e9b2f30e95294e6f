package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.ros.Awaited;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.rtps.Neighbourhood;
import urbi.UClass;
import urbi.UModule;

/** The first use of {@code Ros} makes a node, which takes as long as these tests want. */
class FirstUseTest {
  private final BlockingQueue<NodeSettings> begun = new LinkedBlockingQueue<>();
  private final BlockingQueue<Supplier<Node>> ends = new LinkedBlockingQueue<>();
  private final BlockingQueue<Node> made = new LinkedBlockingQueue<>();
  private Neighbourhood domain;
  private Kernel kernel;

  @BeforeEach
  void start() throws Exception {
    domain = new Neighbourhood();
    kernel = Kernel.builder().searchPath(List.of(Path.of("../share"))).output(text -> {}).start();
    kernel
        .uobjects()
        .start(new UClass("Ros", new UModule("ros"), name -> new Ros(name, this::make)));
    kernel.start(RosTopic.class);
    kernel.start(RosInput.class);
    kernel.start(RosServer.class);
    kernel.start(RosBridge.class);
    kernel.start(RosAction.class);
    kernel.eval(
        "requireFile(\"urbi/ros.u\"); Ros.version = 2; Ros.domain = %d;"
            .formatted(domain.domain()));
  }

  private Node make(NodeSettings settings, Consumer<String> people) {
    begun.add(settings);
    Node node;
    try {
      Supplier<Node> end = Awaited.next(ends);
      node = end == USUAL ? settings.start(people) : end.get();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
    made.add(node);
    return node;
  }

  private static final Supplier<Node> USUAL =
      () -> {
        throw new AssertionError("the one that was asked for");
      };

  private static final NodeSettings SETTINGS =
      new NodeSettings(Dialect.ROS_2, "", "", "0", "", Map.of(), Map.of());

  private static final Function<NodeSettings, Node> MAKER = settings -> USUAL.get();

  private static Supplier<Node> failing(RuntimeException failure) {
    return () -> {
      throw failure;
    };
  }

  private static Supplier<Node> failing(Error failure) {
    return () -> {
      throw failure;
    };
  }

  @AfterEach
  void end() throws Exception {
    kernel.close();
    domain.close();
  }

  private static String refusal(CompletableFuture<Object> asked) {
    CompletionException failure =
        assertThrows(CompletionException.class, () -> Awaited.value(asked));
    return failure.getCause().getMessage();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Ros.name;",
        "Ros.checkMaster;",
        "Ros.time;",
        "Ros.stamp;",
        "Ros.topics;",
        "Ros.frames;",
        "Ros.params;",
        "Ros.log(\"info\", \"well\");",
        "Ros.setParam(\"a\", 1);",
        "Ros.Topic.new(\"/x\")|;",
        "Ros.Bridge.new.listen(0);",
        "Ros.offer(\"/x\", \"std_srvs/Empty\", function (var request) { [=>] })|;"
      })
  void othersGoOnWhileItIsMade(String code) throws Exception {
    CompletableFuture<Object> answer = kernel.evalAsync(code);
    Awaited.next(begun);
    kernel.eval(
        """
        var Global.turns = 0|;
        var Global.turning = Tag.new|;
        turning: every (10ms) turns++,
        waituntil (turns > 3);
        turning.stop;
        """);
    assertFalse(answer.isDone());
    ends.add(USUAL);
    Awaited.value(answer);
  }

  @Test
  void anotherLobbyGoesOnWhileItIsMade() throws Exception {
    BlockingQueue<String> said = new LinkedBlockingQueue<>();
    Connection other =
        kernel.connect(
            new Client() {
              @Override
              public void output(String bytes) {
                said.add(bytes);
              }

              @Override
              public void closed() {}
            });
    CompletableFuture<Object> answer = kernel.evalAsync("Ros.name;");
    Awaited.next(begun);
    other.send("every (10ms) echo(\"turn\"),\n");
    for (int turns = 0; turns < 4; ) {
      if (Awaited.next(said).contains("turn")) {
        turns++;
      }
    }
    assertFalse(answer.isDone());
    ends.add(USUAL);
    Awaited.value(answer);
  }

  @Test
  void whoeverAsksMeanwhileWaitsForTheSameOne() throws Exception {
    CompletableFuture<Object> first = kernel.evalAsync("Ros.name;");
    Awaited.next(begun);
    CompletableFuture<Object> second = kernel.evalAsync("Ros.name;");
    kernel.eval("sleep(20ms);");
    ends.add(USUAL);
    assertEquals(Awaited.value(first), Awaited.value(second));
    kernel.eval("Ros.name;");
    assertTrue(begun.isEmpty());
  }

  @Test
  void whatIsSetTooLateIsRefused() throws Exception {
    CompletableFuture<Object> name = kernel.evalAsync("Ros.name;");
    Awaited.next(begun);
    kernel.eval("Ros.version = 1;");
    assertEquals(2, kernel.eval("Ros.version", int.class));
    String refused =
        assertThrows(UrbiError.class, () -> kernel.eval("Ros.remap(\"/a\", \"/b\");")).getMessage();
    assertTrue(refused.contains("names are remapped before Ros is used"), refused);
    kernel.eval("Ros.nodeName = \"late\"; Ros.packagePath = \"/elsewhere\";");
    kernel.eval("Ros.domain = %d;".formatted(domain.domain() + 1));
    assertTrue(kernel.eval("Ros.nodeName == \"\" && Ros.packagePath == \"\"", boolean.class));
    assertEquals(domain.domain(), kernel.eval("Ros.domain.asFloat", int.class));
    ends.add(USUAL);
    Awaited.value(name);
  }

  /** Who hears of a setting may let others run: those who use Ros do not hold the kernel then. */
  @Test
  void othersUseItWhileItIsChosen() throws Exception {
    CompletableFuture<Object> chosen =
        kernel.evalAsync(
            """
            var Global.heard = false|;
            var Global.gate = false|;
            Ros.&packagePath.notifyChange(closure () { heard = true| waituntil (gate) })|;
            Ros.version = 1;
            """);
    kernel.eval("waituntil (heard)| Ros.remap(\"/a\", \"/b\")| gate = true;");
    Awaited.value(chosen);
    assertEquals(1, kernel.eval("Ros.version", int.class));
  }

  @Test
  void whatIsChosenCountsUntilSomebodyUsesTheNode() throws Exception {
    CompletableFuture<Object> ahead = kernel.evalAsync("Ros.__ahead;");
    Awaited.next(begun);
    ends.add(USUAL);
    Awaited.value(ahead);
    Node first = Awaited.next(made);
    kernel.eval("Ros.nodeName = \"robot\"; Ros.remap(\"/a\", \"/b\");");
    CompletableFuture<Object> topic = kernel.evalAsync("Ros.Topic.new(\"/a\").name;");
    assertEquals("robot", Awaited.next(begun).name());
    ends.add(USUAL);
    assertEquals("/b", Awaited.value(topic));
    Awaited.until("the first node ends", () -> !first.reachable().join());
    assertEquals("/robot", kernel.eval("Ros.name"));
  }

  @Test
  void whatIsChosenWhileTheNodeIsMadeCounts() throws Exception {
    CompletableFuture<Object> ahead = kernel.evalAsync("Ros.__ahead;");
    Awaited.next(begun);
    kernel.eval("Ros.nodeName = \"robot\";");
    CompletableFuture<Object> name = kernel.evalAsync("Ros.name;");
    assertEquals("robot", Awaited.next(begun).name());
    ends.add(USUAL);
    ends.add(USUAL);
    assertEquals("/robot", Awaited.value(name));
    Awaited.value(ahead);
    List<Node> both = List.of(Awaited.next(made), Awaited.next(made));
    Awaited.until(
        "one of them ends",
        () -> both.stream().filter(each -> each.reachable().join()).count() == 1);
  }

  @Test
  void aNodeThatWasMadeAheadIsUsed() throws Exception {
    CompletableFuture<Object> ahead = kernel.evalAsync("Ros.__ahead;");
    ends.add(USUAL);
    Awaited.value(ahead);
    kernel.eval("Ros.name; Ros.__ahead;");
    assertEquals(1, begun.size());
  }

  @Test
  void whenItCannotBeMadeAllAreToldAndTheNextTriesAgain() throws Exception {
    refusedToTwo(failing(new RosException("Too many open files")), "Too many open files");
    refusedToTwo(failing(new OutOfMemoryError("Java heap space")), "OutOfMemoryError");
    refusedToTwo(failing(new UnsatisfiedLinkError("librcl.so")), "UnsatisfiedLinkError: librcl");
    refusedToTwo(failing(new IllegalStateException("a defect")), "a defect");
    ends.add(USUAL);
    assertTrue(kernel.eval("Ros.checkMaster", boolean.class));
  }

  private void refusedToTwo(Supplier<Node> failure, String reason) throws Exception {
    CompletableFuture<Object> first = kernel.evalAsync("Ros.name;");
    Awaited.next(begun);
    CompletableFuture<Object> second = kernel.evalAsync("Ros.Topic.new(\"/x\");");
    kernel.eval("sleep(20ms);");
    ends.add(failure);
    String one = refusal(first);
    String other = refusal(second);
    assertTrue(one.contains(reason), one);
    assertTrue(other.contains(reason), other);
    begun.clear();
  }

  @Test
  void whatIsWrongInTheSettingsIsTold() {
    ends.add(USUAL);
    String refused =
        assertThrows(UrbiError.class, () -> kernel.eval("Ros.domain = \"x\"| Ros.name;"))
            .getMessage();
    assertTrue(refused.contains("ROS_DOMAIN_ID is a number from 0 to 232"), refused);
    ends.add(USUAL);
    kernel.eval("Ros.domain = %d| Ros.name;".formatted(domain.domain()));
  }

  @Test
  void aJobThatIsStoppedLeavesNothingBehind() throws Exception {
    kernel.eval(
        """
        var Global.tag = Tag.new|;
        class Global.sonar { UVar.new(this, "val") }|;
        tag: Ros.input(sonar.&val, "/range", "data", "std_msgs/Float32"),
        tag: Ros.offer("/ours", "std_srvs/Empty", function (var request) { [=>] }),
        """);
    Awaited.next(begun);
    kernel.eval("sleep(20ms)| tag.stop;");
    ends.add(USUAL);
    // The node is there for the next one.
    kernel.eval("Ros.Topic.new(\"/x\");");
    assertTrue(begun.isEmpty());
    kernel.eval("var Global.ours = Ros.nodes[Ros.name]|;");
    assertTrue(kernel.eval("\"/range\" not in ours[\"subscribe\"]", boolean.class));
    assertTrue(kernel.eval("\"/ours\" not in ours[\"services\"]", boolean.class));
  }

  @Test
  void aBridgeThatIsClosedMeanwhileDoesNotListen() throws Exception {
    CompletableFuture<Object> port =
        kernel.evalAsync("var Global.bridge = Ros.Bridge.new| bridge.listen(0);");
    Awaited.next(begun);
    kernel.eval("bridge.close;");
    ends.add(USUAL);
    assertTrue(refusal(port).contains("this bridge was closed before it could listen"));
    assertTrue(kernel.eval("bridge.port == 0 && bridge.listen(0) > 0", boolean.class));
  }

  @Test
  void aKernelThatClosesMeanwhileDoesNotWaitAndLeavesNoNode() throws Exception {
    kernel.evalAsync("Ros.name;");
    Awaited.next(begun);
    kernel.close();
    ends.add(USUAL);
    Node node = Awaited.next(made);
    Awaited.until("the node ends", () -> !node.reachable().join());
  }

  @Test
  void whereNoThreadIsLeftTheNextTriesAgain() {
    FirstUse use =
        new FirstUse(task -> {
          throw new OutOfMemoryError("unable to create native thread");
        });
    for (int i = 0; i < 2; i++) {
      CompletableFuture<Node> none = use.node(SETTINGS, MAKER).toCompletableFuture();
      assertTrue(none.isCompletedExceptionally());
      assertInstanceOfRos(none);
      assertNull(use.used());
    }
    use.close();
    assertInstanceOfRos(use.node(SETTINGS, MAKER).toCompletableFuture());
  }

  private static void assertInstanceOfRos(CompletableFuture<Node> failed) {
    assertTrue(failed.exceptionNow() instanceof RosException);
  }
}
