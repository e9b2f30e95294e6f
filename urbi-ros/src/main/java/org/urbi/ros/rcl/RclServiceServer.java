package org.urbi.ros.rcl;

import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import org.urbi.ros.codec.CodecException;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.message.ServiceType;
import urbi.UDictionary;

/** A service that this node offers. */
final class RclServiceServer implements ServiceServer {
  /** {@code rmw_request_id_t}: whose request it is, and which. */
  private static final long IDENTITY = 24;

  private final RclNode node;
  private final String service;
  private final ServiceType type;
  private final Handler handler;
  private final ServiceSupport support;
  private final Entity entity;

  /** Only for those who hold the lock of the entity. */
  private final MemorySegment identity;

  private final Arrivals.Source source;

  RclServiceServer(RclNode node, String service, ServiceType type, Handler handler) {
    this.node = node;
    this.service = service;
    this.type = type;
    this.handler = handler;
    support = node.support(type);
    entity = new Entity(node.session(), "service", support.handle(), service, null);
    identity = entity.allocate(IDENTITY);
    source = node.arrivals().source(this::take);
    entity.hear(source, "request");
    node.opened(this);
  }

  private void take() {
    while (takeOne()) {}
  }

  private boolean takeOne() {
    byte[][] who = {{}};
    UDictionary[] asked = {null};
    boolean[] taken = {false};
    entity.use(memory -> {
      MemorySegment request = support.request().create();
      try {
        taken[0] = entity.take("rcl_take_request", memory, identity, request);
        if (!taken[0]) return;
        who[0] = identity.toArray(ValueLayout.JAVA_BYTE);
        asked[0] = support.request().read(request, entity.bytes());
      } catch (CodecException e) {
        node.reports().tell(service + ": what comes is no request", e);
      } finally {
        support.request().destroy(request);
      }
    });
    if (asked[0] != null) answer(who[0], asked[0]);
    return taken[0];
  }

  private void answer(byte[] who, UDictionary asked) {
    // ROS 2 has no way to tell why there is no answer.
    handler
        .answer(asked)
        .thenAccept(answer -> send(who, answer))
        .whenComplete((nothing, failure) -> {
          if (failure != null)
            node.reports().tell(service + " failed, and gave no answer", failure);
        });
  }

  private void send(byte[] who, UDictionary answer) {
    entity.use(memory -> {
      MemorySegment response = support.response().create();
      try {
        support.response().write(answer, response, entity.bytes());
        identity.copyFrom(MemorySegment.ofArray(who));
        node.session().functions().check("rcl_send_response", memory, identity, response);
      } finally {
        support.response().destroy(response);
      }
    });
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
  public void close() {
    source.close();
    entity.close();
    node.closed(this);
  }
}
