package org.urbi.ros.one;

import java.io.IOException;

/** What is no XML-RPC, or a fault that the other side has told. */
final class XmlRpcException extends IOException {
  XmlRpcException(String message) {
    super(message);
  }
}
