/** The program {@code urbi-launch-java}: UObjects in Java, plugged and remote. */
package org.urbi.server.launch;
