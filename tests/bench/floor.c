/* The floor of the session path: an epoll server that does what a session does on the wire and nothing else.
 *
 * floor PORT CONNECTIONS POLL: dials that many vehicles, asks each for STATUS every POLL seconds, checks and keeps every STATUS that comes,
 * and acknowledges it.
 */
#include "wire.h"

typedef struct {
    int fd, held;
    uint32_t dev_id, status1, status2;
    uint64_t barcode, frames;
    uint16_t seq;
    double heard;
    uint8_t in[4096];
} Vehicle;

static uint64_t polls = 1ull << 32;

static void say(Vehicle *v, const uint8_t *data, int size) {
    if (send(v->fd, data, (size_t)size, MSG_NOSIGNAL) != size) die("send");
}

static void poll_status(Vehicle *v) {
    uint8_t packet[ENQ_SIZE] = {ENQ};
    put(packet + 1, 4, v->dev_id);
    put(packet + 5, 8, ++polls);
    put(packet + CODE_AT, 2, STATUS);
    seal(packet, ENQ_SIZE);
    say(v, packet, ENQ_SIZE);
}

static void take(Vehicle *v, const uint8_t *packet, double now) {
    if (!sound(packet, ENQ_SIZE) || get(packet + 1, 4) != v->dev_id || get(packet + CODE_AT, 2) != STATUS) {
        fprintf(stderr, "floor: a packet that is no STATUS of vehicle %u\n", v->dev_id);
        exit(1);
    }
    const uint8_t *body = packet + BODY_AT;
    v->heard = now;
    v->frames++;
    v->status1 = (uint32_t)get(body, 4);
    v->status2 = (uint32_t)get(body + 4, 4);
    v->barcode = get(body + 8, 6);
    v->seq = (uint16_t)get(body + 14, 2);
    uint8_t ack[ACK_SIZE] = {ACK};
    memcpy(ack + 1, packet + 1, IDS);
    seal(ack, ACK_SIZE);
    say(v, ack, ACK_SIZE);
}

static int received(Vehicle *v, double now) {
    ssize_t size = recv(v->fd, v->in + v->held, sizeof v->in - (size_t)v->held, 0);
    if (size < 0 && errno == EAGAIN) return 1;
    if (size <= 0) return 0;
    v->held += (int)size;
    int at = 0;
    while (v->held - at >= 1) {
        int need = v->in[at] == ENQ ? ENQ_SIZE : ACK_SIZE;
        if (v->held - at < need) break;
        if (need == ENQ_SIZE) take(v, v->in + at, now);
        at += need;
    }
    v->held -= at;
    memmove(v->in, v->in + at, (size_t)v->held);
    return 1;
}

int main(int argc, char **argv) {
    if (argc != 4) return 2;
    crc_init();
    struct sockaddr_in address = loopback(atoi(argv[1]));
    int count = atoi(argv[2]), epoll = epoll_create1(0), clock = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK);
    Vehicle *vehicles = calloc((size_t)count, sizeof *vehicles);
    for (int i = 0; i < count; i++) {
        Vehicle *v = vehicles + i;
        v->dev_id = (uint32_t)i + 1;
        v->fd = socket(AF_INET, SOCK_STREAM, 0);
        if (connect(v->fd, (struct sockaddr *)&address, sizeof address)) die("connect");
        tune(v->fd);
        watch(epoll, v->fd, v);
        poll_status(v);
    }
    struct itimerspec interval = {{atoi(argv[3]), 0}, {atoi(argv[3]), 0}};
    timerfd_settime(clock, 0, &interval, NULL);
    watch(epoll, clock, NULL);
    struct epoll_event events[1024];
    for (;;) {
        int ready = epoll_wait(epoll, events, 1024, -1);
        double now = seconds();
        for (int i = 0; i < ready; i++) {
            Vehicle *v = events[i].data.ptr;
            if (v && !received(v, now)) return 0;
            uint64_t ticks;
            if (!v && read(clock, &ticks, sizeof ticks) > 0)
                for (int k = 0; k < count; k++) poll_status(vehicles + k);
        }
    }
}
