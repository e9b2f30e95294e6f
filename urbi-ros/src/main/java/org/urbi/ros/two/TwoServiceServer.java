package org.urbi.ros.two;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.Queue;
import org.urbi.ros.codec.CodecException;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.TypeHash;
import org.urbi.ros.rtps.EndpointInfo;
import org.urbi.ros.rtps.Guid;
import org.urbi.ros.rtps.Reader;
import org.urbi.ros.rtps.ReaderListener;
import org.urbi.ros.rtps.Sample;
import org.urbi.ros.rtps.SampleIdentity;
import org.urbi.ros.rtps.Writer;
import org.urbi.ros.rtps.WriterListener;
import urbi.UDictionary;

/** A service of ROS 2 that this node offers. */
final class TwoServiceServer implements ServiceServer {
  /** Answers that wait for their client's reader to be found. */
  private static final int MOST_EARLY = 100;

  private record Early(SampleIdentity request, ByteBuffer answer) {}

  private final TwoNode node;
  private final String service;
  private final ServiceType type;
  private final Handler handler;
  private final MessageCodec requests;
  private final MessageCodec replies;
  private final Queue<Early> early = new ArrayDeque<>();
  private final Writer writer;
  private final Reader reader;

  TwoServiceServer(TwoNode node, String service, ServiceType type, Handler handler) {
    this.node = node;
    this.service = service;
    this.type = type;
    this.handler = handler;
    requests = MessageCodec.of(type.request());
    replies = MessageCodec.of(type.response());
    writer =
        node.writer(
            Mangling.reply(service),
            Mangling.type(type.response().name()),
            TwoServiceClient.QOS,
            TypeHash.rihs(type.response()),
            new Clients());
    reader =
        node.reader(
            Mangling.request(service),
            Mangling.type(type.request().name()),
            TwoServiceClient.QOS,
            TypeHash.rihs(type.request()),
            new Requests());
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
    node.close(reader);
    node.close(writer);
  }

  private void answer(Sample request) {
    SampleIdentity related = request.related();
    Guid client = related != null ? related.writer() : request.identity().writer();
    SampleIdentity identity = new SampleIdentity(client, request.identity().sequence());
    ByteBuffer bytes = request.payload();
    UDictionary asked;
    try {
      asked = requests.decode(bytes);
    } catch (CodecException e) {
      // ROS 2 has no way to refuse: whoever sends something that is not a request gets no answer.
      String owner = node.owners().now(client);
      node.reports().tell(service + ": " + owner + " sends what is no request", e);
      return;
    }
    // Nor has it one to tell why there is none.
    handler
        .answer(asked)
        .thenAccept(answer -> send(identity, ByteBuffer.wrap(replies.encode(answer))))
        .whenComplete((nothing, failure) -> {
          if (failure != null)
            node.reports().tell(service + " failed, and gave no answer", failure);
        });
  }

  private synchronized void send(SampleIdentity request, ByteBuffer answer) {
    if (writer.matched().contains(request.writer()) || !isReader(request.writer())) {
      writer.write(answer, request);
      return;
    }
    // The request was faster than what told of the reader that waits.
    if (early.size() >= MOST_EARLY) early.remove();
    early.add(new Early(request, answer));
  }

  private static boolean isReader(Guid guid) {
    return (guid.entity() & 0xff) == 0x04;
  }

  private synchronized void found(Guid client) {
    for (Iterator<Early> all = early.iterator(); all.hasNext(); ) {
      Early each = all.next();
      if (!each.request.writer().equals(client)) continue;
      all.remove();
      writer.write(each.answer, each.request);
    }
  }

  private final class Clients implements WriterListener {
    @Override
    public void matched(Writer us, EndpointInfo client) {
      found(client.guid());
    }
  }

  private final class Requests implements ReaderListener {
    @Override
    public void available(Reader us) {
      node.takeAll(us, TwoServiceServer.this::answer);
    }
  }
}
