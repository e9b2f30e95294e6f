package org.urbi.ros.uobject;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UObject;
import urbi.UVar;

/** A service of another node that urbiscript calls (manual, "Ros.Service"). */
public final class RosService extends UObject implements AutoCloseable {
  static {
    UStart(RosService.class);
  }

  /** Seconds. */
  private static final int PATIENCE = 60;

  private final UVar initialized = new UVar();
  private final UVar patience = new UVar();
  private String service = "";
  private volatile @Nullable ServiceClient client;

  public RosService(String name) {
    super(name);
    UBindVars(initialized, "initialized", patience, "patience");
    initialized.setValue(0);
    patience.setValue(PATIENCE);
    UBindFunctions("init", "name", "reqStruct", "resStruct", "request");
  }

  /**
   * Looks the service up. The job waits until it is there.
   *
   * @param keepAlive whether the connection is kept between requests
   */
  public CompletionStage<Void> init(String name, boolean keepAlive) {
    Node node = Ros.of(this);
    service = node.resolve(name);
    return node.client(name, null, keepAlive)
        .thenAccept(found -> {
          client = found;
          initialized.setValue(1);
        });
  }

  private ServiceClient client() {
    ServiceClient known = client;
    if (known == null) {
      throw new RosException(service + " is not initialized");
    }
    return known;
  }

  /** The full name of the service. */
  public String name() {
    return service;
  }

  /** A new request. */
  public UDictionary reqStruct() {
    return Templates.of(client().type().request());
  }

  /** A new response. */
  public UDictionary resStruct() {
    return Templates.of(client().type().response());
  }

  /**
   * Asks the service. The job waits for the answer, at most for the seconds of {@code patience}.
   */
  public CompletionStage<UDictionary> request(UDictionary request) {
    double seconds = patience.doubleValue();
    if (!(seconds > 0)) {
      throw new RosException("patience: seconds, more than 0, expected, or inf");
    }
    long most = (long) Math.ceil(seconds * 1000);
    return client()
        .request(request)
        .orTimeout(most, TimeUnit.MILLISECONDS)
        .exceptionallyCompose(failure ->
            CompletableFuture.failedFuture(
                failure instanceof TimeoutException
                    ? new RosException(
                        service + " has not answered within " + most + " ms", failure)
                    : failure));
  }

  @Override
  public void close() {
    ServiceClient known = client;
    if (known != null) {
      known.close();
    }
  }
}
