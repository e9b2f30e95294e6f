package org.urbi.server.trust;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.server.tools.ToolResult;
import org.urbi.server.tools.UrbiCertificate;

/** The files of TLS, and what can be wrong with them. */
class ServerIdentityTest {
  @TempDir static Path folder;
  private static Path certificate;
  private static Path key;

  @BeforeAll
  static void make() {
    assertEquals(0, certificate("own", "robot.example", "10.0.0.1", "--days=10").status());
    certificate = folder.resolve("own.crt");
    key = folder.resolve("own.key");
  }

  private static ToolResult certificate(String name, String... words) {
    String[] all = new String[words.length + 1];
    all[0] = folder.resolve(name).toString();
    System.arraycopy(words, 0, all, 1, words.length);
    return ToolResult.of(UrbiCertificate::run, all);
  }

  private static String refusal(Path certificate, Path key) {
    return assertThrows(IOException.class, () -> ServerIdentity.read(certificate, key))
        .getMessage();
  }

  private static Path file(String name, String text) throws IOException {
    Path file = Files.writeString(folder.resolve(name), text);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
    return file;
  }

  @Test
  void whatIsMadeCanBeUsed() throws Exception {
    ServerIdentity identity = ServerIdentity.read(certificate, key);
    assertEquals(List.of(), identity.warnings());
    assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(key)));
    String names = identity.chain().getFirst().getSubjectAlternativeNames().toString();
    assertTrue(names.contains("robot.example") && names.contains("10.0.0.1"), names);
  }

  @Test
  void nothingIsWrittenOver() throws IOException {
    String before = Files.readString(key);
    ToolResult again = certificate("own");
    assertEquals(1, again.status());
    assertTrue(again.err().contains("own.key already"), again.err());
    assertEquals(before, Files.readString(key));
  }

  @Test
  void aFolderThatIsNotThereIsSaid() {
    ToolResult run = certificate("no/such/folder");
    assertEquals(1, run.status());
    assertTrue(run.err().contains("no/such/folder.key"), run.err());
  }

  @Test
  void filesThatAreNotThereAreSaid() {
    Path missing = folder.resolve("missing");
    assertEquals("no such file: " + missing, refusal(missing, key));
    assertEquals("no such file: " + missing, refusal(certificate, missing));
    assertEquals("cannot read " + folder, refusal(folder, key));
  }

  @Test
  void filesOfAnotherKindAreSaid() throws IOException {
    assertEquals("no certificate in PEM: " + key, refusal(key, key));
    assertEquals("no private key in PEM: " + certificate, refusal(certificate, certificate));
    Path empty = file("empty", "");
    assertEquals("no certificate in PEM: " + empty, refusal(empty, key));
    assertEquals("no private key in PEM: " + empty, refusal(certificate, empty));
    Path damaged =
        file("damaged", "-----BEGIN PRIVATE KEY-----\nMEECAQAw\n-----END PRIVATE KEY-----\n");
    assertEquals("the private key is damaged: " + damaged, refusal(certificate, damaged));
    Path old = file("old", "-----BEGIN RSA PRIVATE KEY-----\n");
    assertTrue(refusal(certificate, old).contains("openssl pkcs8 -topk8"));
    Path locked = file("locked", "-----BEGIN ENCRYPTED PRIVATE KEY-----\n");
    assertTrue(refusal(certificate, locked).contains("has a passphrase"));
  }

  @Test
  void aKeyOfAnotherCertificateIsSaid() {
    assertEquals(0, certificate("another").status());
    Path another = folder.resolve("another.key");
    assertEquals(
        "the key in " + another + " does not fit the certificate in " + certificate,
        refusal(certificate, another));
  }

  @Test
  void aKeyThatOthersCanReadIsWarnedOf() throws IOException {
    Path open = folder.resolve("open.key");
    Files.copy(key, open);
    Files.setPosixFilePermissions(open, PosixFilePermissions.fromString("rw-r--r--"));
    List<String> warnings = ServerIdentity.read(certificate, open).warnings();
    assertEquals(List.of(open + " can be read or written by others: chmod 600 " + open), warnings);
  }
}
