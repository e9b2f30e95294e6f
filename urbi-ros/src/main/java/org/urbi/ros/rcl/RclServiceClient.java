package org.urbi.ros.rcl;

import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.codec.CodecException;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.message.ServiceType;
import urbi.UDictionary;

/** What calls a service. */
final class RclServiceClient implements ServiceClient {
  private static final long PATIENCE_SECONDS = 5;

  /** {@code rmw_request_id_t}, and where in it is the number of the request. */
  private static final long IDENTITY = 24;

  private static final long NUMBER = 16;

  private final RclNode node;
  private final String service;
  private final ServiceType type;
  private final ServiceSupport support;
  private final Entity entity;
  private final MemorySegment identity;
  private final MemorySegment flag;
  private final Arrivals.Source source;
  private final Runnable stopsSeeking;
  private final Map<Long, CompletableFuture<UDictionary>> waiting = new HashMap<>();
  private final CompletableFuture<ServiceClient> ready = new CompletableFuture<>();

  RclServiceClient(RclNode node, String service, ServiceType type) {
    this.node = node;
    this.service = service;
    this.type = type;
    support = node.support(type);
    entity = new Entity(node.session(), "client", support.handle(), service, null);
    identity = entity.allocate(IDENTITY);
    flag = entity.allocate(1);
    source = node.arrivals().source(this::take);
    entity.hear(source, "response");
    stopsSeeking = node.seek(this::look);
    node.opened(this);
    look();
  }

  /** Itself, when there is a server. */
  CompletableFuture<ServiceClient> ready() {
    return ready
        .orTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS)
        .exceptionallyCompose(failure -> {
          close();
          return CompletableFuture.failedFuture(
              new RosException(
                  "the service " + service + " is not there, or of another type", failure));
        });
  }

  private void look() {
    if (isThere()) ready.complete(this);
    else gone();
  }

  private boolean isThere() {
    boolean[] there = {false};
    entity.use(memory -> {
      node.session()
          .functions()
          .check("rcl_service_server_is_available", node.session().node(), memory, flag);
      there[0] = flag.get(ValueLayout.JAVA_BOOLEAN, 0);
    });
    return there[0];
  }

  private void gone() {
    List<CompletableFuture<UDictionary>> lost;
    synchronized (waiting) {
      lost = new ArrayList<>(waiting.values());
      waiting.clear();
    }
    RosException reason = new RosException("the service " + service + " has gone");
    lost.forEach(each -> each.completeExceptionally(reason));
  }

  @Override
  public String service() {
    return service;
  }

  @Override
  public ServiceType type() {
    return type;
  }

  @Override
  public CompletableFuture<UDictionary> request(UDictionary request) {
    CompletableFuture<UDictionary> answer = new CompletableFuture<>();
    // The reply may come before the number is known here: it waits for the lock.
    synchronized (waiting) {
      if (!isThere()) {
        answer.completeExceptionally(new RosException("the service " + service + " has gone"));
        return answer;
      }
      entity.use(memory -> {
        long number = send(memory, request);
        waiting.put(number, answer);
        // The number is forgotten, too, when whoever has asked no longer wants the answer.
        answer.whenComplete((value, failure) -> answered(number));
      });
    }
    return answer;
  }

  private long send(MemorySegment memory, UDictionary request) {
    MemorySegment message = support.request().create();
    try {
      support.request().write(request, message, entity.bytes());
      node.session()
          .functions()
          .check("rcl_send_request", memory, message, identity.asSlice(NUMBER));
      return identity.get(ValueLayout.JAVA_LONG, NUMBER);
    } finally {
      support.request().destroy(message);
    }
  }

  private @Nullable CompletableFuture<UDictionary> answered(long number) {
    synchronized (waiting) {
      return waiting.remove(number);
    }
  }

  private void take() {
    while (takeOne()) {}
  }

  private boolean takeOne() {
    boolean[] taken = {false};
    Runnable[] told = {() -> {}};
    entity.use(memory -> {
      MemorySegment response = support.response().create();
      try {
        taken[0] = entity.take("rcl_take_response", memory, identity, response);
        if (!taken[0]) return;
        long number = identity.get(ValueLayout.JAVA_LONG, NUMBER);
        told[0] = outcome(number, response);
      } finally {
        support.response().destroy(response);
      }
    });
    told[0].run();
    return taken[0];
  }

  /** What is to be told, by somebody who holds no lock. */
  private Runnable outcome(long number, MemorySegment response) {
    try {
      UDictionary value = support.response().read(response, entity.bytes());
      return () -> {
        CompletableFuture<UDictionary> answer = answered(number);
        if (answer != null) answer.complete(value);
      };
    } catch (CodecException | RosException e) {
      return () -> {
        CompletableFuture<UDictionary> answer = answered(number);
        if (answer != null)
          answer.completeExceptionally(
              new RosException(service + " answers what is none: " + e.getMessage(), e));
      };
    }
  }

  @Override
  public void close() {
    stopsSeeking.run();
    source.close();
    entity.close();
    gone();
    node.closed(this);
  }
}
