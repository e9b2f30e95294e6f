package org.urbi.ros.two;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import org.urbi.ros.codec.CodecException;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.TypeHash;
import org.urbi.ros.rtps.EndpointInfo;
import org.urbi.ros.rtps.EndpointQos;
import org.urbi.ros.rtps.Guid;
import org.urbi.ros.rtps.Reader;
import org.urbi.ros.rtps.ReaderListener;
import org.urbi.ros.rtps.Sample;
import org.urbi.ros.rtps.SampleIdentity;
import org.urbi.ros.rtps.Writer;
import org.urbi.ros.rtps.WriterListener;
import urbi.UDictionary;

/**
 * What calls a service of ROS 2: requests that carry the name of the reader that waits for the
 * replies.
 */
final class TwoServiceClient implements ServiceClient {
  static final EndpointQos QOS = EndpointQos.reliable(10);

  /** The number of no sample: a request answers none. */
  private static final long NO_SEQUENCE = -1L << 32;

  private static final long PATIENCE_SECONDS = 5;

  private final TwoNode node;
  private final String service;
  private final ServiceType type;
  private final MessageCodec requests;
  private final MessageCodec replies;
  private final Map<Long, CompletableFuture<UDictionary>> waiting = new ConcurrentHashMap<>();
  private final CompletableFuture<ServiceClient> ready = new CompletableFuture<>();
  private final Writer writer;
  private final Reader reader;

  TwoServiceClient(TwoNode node, String service, ServiceType type) {
    this.node = node;
    this.service = service;
    this.type = type;
    requests = MessageCodec.of(type.request());
    replies = MessageCodec.of(type.response());
    String hash = TypeHash.rihs(type.whole());
    reader =
        node.reader(
            Mangling.reply(service),
            Mangling.type(type.response().name()),
            QOS,
            hash,
            new Replies());
    writer =
        node.writer(
            Mangling.request(service),
            Mangling.type(type.request().name()),
            QOS,
            hash,
            new Servers());
    checkReady();
  }

  /** Itself, when a server both hears it and is heard. */
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

  private void checkReady() {
    // The listeners may be called before the constructor is done.
    if (writer == null || reader == null) return;
    List<Guid> heard = reader.matched();
    for (Guid each : writer.matched())
      if (heard.stream().anyMatch(other -> other.prefix().equals(each.prefix())))
        ready.complete(this);
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
    ByteBuffer bytes = ByteBuffer.wrap(requests.encode(request));
    CompletableFuture<UDictionary> answer = new CompletableFuture<>();
    // The reply may come before the number is known here: it waits for the lock.
    synchronized (waiting) {
      if (writer.matched().isEmpty()) {
        answer.completeExceptionally(new RosException("the service " + service + " has gone"));
        return answer;
      }
      long number = writer.write(bytes, new SampleIdentity(reader.guid(), NO_SEQUENCE));
      if (number == 0) answer.completeExceptionally(new RosException("the client is closed"));
      else waiting.put(number, answer);
    }
    return answer;
  }

  private void gone() {
    if (writer == null || !writer.matched().isEmpty()) return;
    RosException reason = new RosException("the service " + service + " has gone");
    for (Long each : List.copyOf(waiting.keySet())) {
      CompletableFuture<UDictionary> answer = waiting.remove(each);
      if (answer != null) answer.completeExceptionally(reason);
    }
  }

  @Override
  public void close() {
    node.close(writer);
    node.close(reader);
    gone();
  }

  private final class Servers implements WriterListener {
    @Override
    public void matched(Writer us, EndpointInfo server) {
      checkReady();
    }

    @Override
    public void unmatched(Writer us, Guid server) {
      gone();
    }
  }

  private final class Replies implements ReaderListener {
    @Override
    public void matched(Reader us, EndpointInfo server) {
      checkReady();
    }

    @Override
    public void available(Reader us) {
      TwoNode.takeAll(us, this::received);
    }

    private void received(Sample sample) {
      SampleIdentity related = sample.related();
      if (related == null || !isOurs(related.writer())) return;
      CompletableFuture<UDictionary> answer;
      synchronized (waiting) {
        answer = waiting.remove(related.sequence());
      }
      if (answer == null) return;
      ByteBuffer bytes = sample.payload();
      try {
        answer.complete(
            replies.decode(
                bytes.array(), bytes.arrayOffset() + bytes.position(), bytes.remaining()));
      } catch (CodecException e) {
        answer.completeExceptionally(
            new RosException(service + " answers what is none: " + e.getMessage(), e));
      }
    }

    private boolean isOurs(Guid guid) {
      return guid.equals(reader.guid()) || guid.equals(writer.guid());
    }
  }
}
