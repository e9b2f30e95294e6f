/** Events, and what waits for events and conditions. */
package org.urbi.kernel.event;
