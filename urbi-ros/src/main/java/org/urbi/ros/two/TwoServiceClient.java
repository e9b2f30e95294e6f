package org.urbi.ros.two;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
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

  /**
   * A request that has no answer yet.
   *
   * @param servers those that got it and are still there
   */
  private record Asked(CompletableFuture<UDictionary> answer, Set<Guid> servers) {}

  private final TwoNode node;
  private final String service;
  private final ServiceType type;
  private final MessageCodec requests;
  private final MessageCodec replies;
  private final Map<Long, Asked> waiting = new HashMap<>();
  private final CompletableFuture<ServiceClient> ready = new CompletableFuture<>();
  private final Writer writer;
  private final Reader reader;

  TwoServiceClient(TwoNode node, String service, ServiceType type) {
    this.node = node;
    this.service = service;
    this.type = type;
    requests = MessageCodec.of(type.request());
    replies = MessageCodec.of(type.response());
    reader =
        node.reader(
            Mangling.reply(service),
            Mangling.type(type.response().name()),
            QOS,
            TypeHash.rihs(type.response()),
            new Replies());
    writer =
        node.writer(
            Mangling.request(service),
            Mangling.type(type.request().name()),
            QOS,
            TypeHash.rihs(type.request()),
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
      Set<Guid> servers = new HashSet<>(writer.matched());
      if (servers.isEmpty()) {
        answer.completeExceptionally(new RosException("the service " + service + " has gone"));
        return answer;
      }
      long number = writer.write(bytes, new SampleIdentity(reader.guid(), NO_SEQUENCE));
      if (number == 0) {
        answer.completeExceptionally(new RosException("the client is closed"));
        return answer;
      }
      waiting.put(number, new Asked(answer, servers));
      // Also if nobody wants it any more.
      answer.whenComplete((value, failure) -> answered(number));
    }
    return answer;
  }

  private @Nullable Asked answered(long number) {
    synchronized (waiting) {
      return waiting.remove(number);
    }
  }

  /**
   * A server has gone: requests that no other server could answer fail. A server that has come
   * after a request does not know of it.
   */
  private void gone(Predicate<Guid> who) {
    List<CompletableFuture<UDictionary>> lost = new ArrayList<>();
    synchronized (waiting) {
      for (Asked each : waiting.values()) {
        each.servers.removeIf(who);
        if (each.servers.isEmpty()) lost.add(each.answer);
      }
    }
    RosException reason = new RosException("the service " + service + " has gone");
    lost.forEach(each -> each.completeExceptionally(reason));
  }

  @Override
  public void close() {
    node.close(writer);
    node.close(reader);
    gone(any -> true);
  }

  private final class Servers implements WriterListener {
    @Override
    public void matched(Writer us, EndpointInfo server) {
      checkReady();
    }

    @Override
    public void unmatched(Writer us, Guid server) {
      gone(server::equals);
    }
  }

  private final class Replies implements ReaderListener {
    @Override
    public void matched(Reader us, EndpointInfo server) {
      checkReady();
    }

    @Override
    public void available(Reader us) {
      node.takeAll(us, this::received);
    }

    private void received(Sample sample) {
      SampleIdentity related = sample.related();
      if (related == null || !isOurs(related.writer())) return;
      Asked asked = answered(related.sequence());
      if (asked == null) return;
      CompletableFuture<UDictionary> answer = asked.answer;
      ByteBuffer bytes = sample.payload();
      try {
        answer.complete(replies.decode(bytes));
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
