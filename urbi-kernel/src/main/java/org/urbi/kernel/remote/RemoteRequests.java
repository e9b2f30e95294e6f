package org.urbi.kernel.remote;

import java.util.function.Function;
import java.util.function.Supplier;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.log.FailureLog;
import urbi.UProperty;
import urbi.UValue;
import urbi.rtp.RtpParameters;
import urbi.wire.Frame;
import urbi.wire.WireException;
import urbi.wire.WireInput;

/** Decodes the requests of a remote process: turns a frame into an action. */
final class RemoteRequests {
  private final RemotePeer peer;
  private final Function<RuntimeException, String> describe;

  /**
   * @param describe gives the text of a failure, and logs a bug of ours; called in a job
   */
  RemoteRequests(RemotePeer peer, Function<RuntimeException, String> describe) {
    this.peer = peer;
    this.describe = describe;
  }

  /**
   * Decodes a frame to the action that it requests, which is not executed yet.
   *
   * @throws WireException if it is no valid request
   */
  Runnable of(int type, WireInput in) {
    return switch (type) {
      case Frame.CLASS -> {
        int number = in.size();
        String name = in.text();
        yield answering(number, () -> peer.startClass(name));
      }
      case Frame.RTP -> {
        int id = in.size();
        boolean on = in.octet() == 1;
        yield () -> peer.variables().get(id).slot().useRtp(on);
      }
      case Frame.RTP_OFFER -> {
        RtpParameters terms = RtpParameters.read(in);
        yield () -> peer.datagrams().open(terms);
      }
      case Frame.FENCE -> answering(in.size(), peer::showClasses);
      case Frame.ATTACH -> {
        int number = in.size();
        String className = in.text();
        yield answering(number, () -> peer.attach(className));
      }
      case Frame.DETACH -> {
        String name = in.text();
        yield () -> peer.detach(name);
      }
      case Frame.BIND -> {
        String object = in.text();
        String function = in.text();
        int arity = in.octet();
        yield () -> peer.bind(object, function, arity);
      }
      case Frame.OPEN -> {
        int number = in.size();
        int id = in.size();
        boolean port = in.octet() == 1;
        String name = in.text();
        yield answering(number, () -> peer.variables().open(id, port, name));
      }
      case Frame.SET -> {
        int id = in.size();
        UValue value = in.value();
        yield () -> peer.variables().get(id).set(value);
      }
      case Frame.CLOSE, Frame.OWN -> {
        int id = in.size();
        yield type == Frame.OWN
            ? () -> peer.variables().get(id).own()
            : () -> peer.variables().close(id);
      }
      case Frame.WATCH, Frame.INTERCEPT -> {
        int id = in.size();
        int how = in.octet();
        yield type == Frame.WATCH
            ? () -> peer.variables().get(id).watch(how)
            : () -> peer.variables().get(id).intercept(how == 1);
      }
      case Frame.SYNC -> {
        int number = in.size();
        int id = in.size();
        yield answering(number, () -> peer.variables().get(id).slot().sync());
      }
      case Frame.GET_PROPERTY -> {
        int number = in.size();
        int id = in.size();
        UProperty property = property(in.text());
        yield answering(number, () -> peer.variables().get(id).slot().property(property));
      }
      case Frame.SET_PROPERTY -> {
        int id = in.size();
        UProperty property = property(in.text());
        UValue value = in.value();
        yield () -> peer.variables().get(id).slot().setProperty(property, value);
      }
      case Frame.EVENT, Frame.EMIT -> {
        String name = in.text();
        UValue[] payload = type == Frame.EMIT ? in.values() : null;
        yield () -> peer.emit(name, payload);
      }
      case Frame.CALL_URBI -> {
        String object = in.text();
        String method = in.text();
        UValue[] arguments = in.values();
        yield () -> peer.context().call(object, method, arguments);
      }
      case Frame.MODULE -> {
        String problem = in.text();
        yield () -> peer.tellOfModule(problem);
      }
      case Frame.REPORT -> {
        String text = in.text();
        yield () -> peer.context().report(text);
      }
      default -> throw new WireException(Problem.NO_KIND_OF_FRAME.text(type));
    };
  }

  private static UProperty property(String text) {
    for (UProperty property : UProperty.values()) {
      if (property.text().equals(text)) {
        return property;
      }
    }
    throw new WireException(Problem.NO_KIND_OF_PROPERTY.text(text));
  }

  /** Wraps an action so that its result, or its failure, is sent to the process. */
  private Runnable answering(int number, Supplier<UValue> question) {
    return () -> {
      try {
        UValue answer = question.get();
        peer.write(o -> o.begin(Frame.REPLY).size(number).value(answer).end());
      } catch (RuntimeException e) {
        refuse(number, describe.apply(e));
      } catch (Error e) {
        FailureLog.internal("an answer to a remote process", e);
        refuse(number, FailureLog.text(e));
      }
    };
  }

  private void refuse(int number, String reason) {
    peer.write(o -> o.begin(Frame.REFUSAL).size(number).text(reason).end());
  }
}
