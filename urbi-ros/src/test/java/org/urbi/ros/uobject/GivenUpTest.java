package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.ros.Awaited;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.rtps.Neighbourhood;
import urbi.UClass;
import urbi.UModule;

/**
 * What jobs wait for of a network that is slow: it is not begun, or is ended again, if they are
 * stopped, or their object is destroyed, before it is there.
 */
class GivenUpTest {
  /** What the network is asked, which answers when a test wants it to. */
  private final BlockingQueue<CompletableFuture<Object>> asked = new LinkedBlockingQueue<>();

  private final AtomicInteger begun = new AtomicInteger();
  private final AtomicInteger closed = new AtomicInteger();
  private Neighbourhood domain;
  private Kernel kernel;

  @BeforeEach
  void start() throws Exception {
    domain = new Neighbourhood();
    kernel = Kernel.builder().searchPath(List.of(Path.of("../share"))).output(text -> {}).start();
    kernel
        .uobjects()
        .start(
            new UClass(
                "Ros",
                new UModule("ros"),
                name -> new Ros(name, (settings, people) -> slow(settings.start(people)))));
    kernel.start(RosTopic.class);
    kernel.start(RosService.class);
    kernel.eval(
        "Ros.version = 2; Ros.domain = %d; var Global.tag = Tag.new|".formatted(domain.domain())
            + " var Global.topic = Ros.Topic.new(\"/x\")|;");
  }

  @AfterEach
  void end() throws Exception {
    kernel.close();
    domain.close();
  }

  /** The node, but what it has to ask others takes as long as a test wants. */
  private Node slow(Node node) {
    return (Node)
        Proxy.newProxyInstance(
            Node.class.getClassLoader(),
            new Class<?>[] {Node.class},
            (proxy, method, arguments) -> called(node, method, arguments));
  }

  private Object called(Node node, Method method, Object[] arguments) throws Throwable {
    switch (method.getName()) {
      case "typeOf", "client", "settled" -> {
        CompletableFuture<Object> answer = new CompletableFuture<>();
        asked.add(answer);
        return answer;
      }
      case "subscribe", "advertise" -> begun.incrementAndGet();
      default -> {}
    }
    try {
      return method.invoke(node, arguments);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }

  private boolean isKnown(String role) {
    return kernel.eval("\"/x\" in Ros.nodes[Ros.name][\"%s\"]".formatted(role), boolean.class);
  }

  @ParameterizedTest
  @ValueSource(strings = {"topic.subscribe", "topic.advertise(\"\")"})
  void whatIsStoppedDoesNotBegin(String code) throws Exception {
    kernel.evalAsync("tag: %s;".formatted(code));
    CompletableFuture<Object> type = Awaited.next(asked);
    kernel.eval("tag.stop| sleep(10ms);");
    type.complete("std_msgs/String");
    assertEquals(0, begun.get());
    // The next one may.
    CompletableFuture<Object> again = kernel.evalAsync("topic.subscribe;");
    Awaited.next(asked).complete("std_msgs/String");
    Awaited.value(again);
    assertEquals(1, begun.get());
  }

  @ParameterizedTest
  @ValueSource(strings = {"subscribe", "publish"})
  void whatHasBegunEndsWhenItIsStopped(String role) throws Exception {
    String begins = role.equals("subscribe") ? "subscribeAs" : "advertise";
    kernel.evalAsync("tag: topic.%s(\"std_msgs/String\");".formatted(begins));
    Awaited.next(asked);
    assertTrue(isKnown(role));
    kernel.eval("tag.stop| sleep(10ms);");
    assertFalse(isKnown(role));
    CompletableFuture<Object> again =
        kernel.evalAsync("topic.%s(\"std_msgs/String\");".formatted(begins));
    Awaited.next(asked).complete(null);
    Awaited.value(again);
    assertTrue(isKnown(role));
  }

  @Test
  void onlyOneBeginsAtATime() throws Exception {
    CompletableFuture<Object> first = kernel.evalAsync("topic.subscribe;");
    CompletableFuture<Object> type = Awaited.next(asked);
    for (String each : new String[] {"subscribe", "init(\"/y\")", "advertise(\"\")"}) {
      String refused =
          assertThrows(UrbiError.class, () -> kernel.eval("topic.%s;".formatted(each)))
              .getMessage();
      assertTrue(refused.contains("/x is being subscribed or advertised"), refused);
    }
    type.complete("std_msgs/String");
    Awaited.value(first);
    assertEquals(1, begun.get());
  }

  @Test
  void whatFailsMayBeTriedAgain() throws Exception {
    CompletableFuture<Object> first = kernel.evalAsync("topic.subscribe;");
    Awaited.next(asked).completeExceptionally(new IllegalStateException("gone"));
    assertThrows(CompletionException.class, () -> Awaited.value(first));
    CompletableFuture<Object> again = kernel.evalAsync("topic.subscribe;");
    Awaited.next(asked).complete("std_msgs/String");
    Awaited.value(again);
  }

  @Test
  void aTopicThatIsDestroyedMeanwhileDoesNotBegin() throws Exception {
    CompletableFuture<Object> first = kernel.evalAsync("topic.subscribe;");
    CompletableFuture<Object> type = Awaited.next(asked);
    kernel.eval("topic.destroy;");
    type.complete("std_msgs/String");
    assertThrows(CompletionException.class, () -> Awaited.value(first));
    assertEquals(0, begun.get());
  }

  @Test
  void aClientThatComesTooLateIsClosed() throws Exception {
    kernel.evalAsync("tag: Ros.Service.new(\"/s\", true);");
    CompletableFuture<Object> found = Awaited.next(asked);
    kernel.eval("tag.stop| sleep(10ms);");
    found.complete(client());
    Awaited.until("the client is closed", () -> closed.get() == 1);
  }

  @Test
  void aClientIsClosedWhenAnotherOneTakesItsPlace() throws Exception {
    CompletableFuture<Object> first =
        kernel.evalAsync("var Global.service = Ros.Service.new(\"/s\", true)|;");
    Awaited.next(asked).complete(client());
    Awaited.value(first);
    assertEquals(0, closed.get());
    CompletableFuture<Object> second = kernel.evalAsync("service.init(\"/t\", true);");
    Awaited.next(asked).complete(client());
    Awaited.value(second);
    assertEquals(1, closed.get());
    kernel.eval("service.destroy;");
    assertEquals(2, closed.get());
  }

  @Test
  void aRequestThatIsStoppedIsNotKept() throws Exception {
    CompletableFuture<Object> made =
        kernel.evalAsync("var Global.service = Ros.Service.new(\"/s\", true)|;");
    Awaited.next(asked).complete(client());
    Awaited.value(made);
    kernel.evalAsync("tag: service.request([ => ]);");
    CompletableFuture<Object> answer = Awaited.next(asked);
    kernel.eval("tag.stop| sleep(10ms);");
    Awaited.until("the answer is given up", answer::isCancelled);
  }

  private ServiceClient client() {
    return (ServiceClient)
        Proxy.newProxyInstance(
            ServiceClient.class.getClassLoader(),
            new Class<?>[] {ServiceClient.class},
            (proxy, method, arguments) -> {
              if (method.getName().equals("request")) {
                CompletableFuture<Object> answer = new CompletableFuture<>();
                asked.add(answer);
                return answer;
              }
              if (method.getName().equals("close")) {
                closed.incrementAndGet();
              }
              return null;
            });
  }
}
