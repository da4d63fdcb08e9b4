/* The load of the session path: many vehicles in one process.
 *
 * vehicles CONNECTIONS PID SETTLE WARM MEASURE WAY RATE: listens (the port is the first line of output), waits until all have connected and
 * been asked, answers polls only for SETTLE seconds, sends events, and after WARM seconds measures for MEASURE seconds:
 * packets acknowledged, and CPU time of process PID by its threads' schedstat. WAY 0: each event brings a new barcode;
 * 1: the vehicle stands and its axes move; 2: no events, only answers to polls. RATE 0: each vehicle has one event outstanding (a closed
 * loop); otherwise so many events a second from all together, at even distances, whether the last ones are acknowledged or not (an open
 * loop). Prints JSON; "waiting" are the events not acknowledged at the end. The PID is read from the first line of input if it is 0.
 */
#include <dirent.h>

#include "wire.h"

typedef struct {
    int fd, held, up;
    uint64_t outstanding, step;
    uint32_t dev_id;
    uint8_t in[4096];
} Vehicle;

static int way, running, asked, rate;
static uint64_t acked, answers, sent, cmd_ids = 1ull << 63;
static Vehicle *vehicles;
static int count;

static uint64_t cpu_of(int pid) {
    char path[300];
    snprintf(path, sizeof path, "/proc/%d/task", pid);
    DIR *tasks = opendir(path);
    if (!tasks) die(path);
    uint64_t sum = 0, one;
    for (struct dirent *task; (task = readdir(tasks));) {
        if (*task->d_name == '.') continue;
        snprintf(path, sizeof path, "/proc/%d/task/%s/schedstat", pid, task->d_name);
        FILE *file = fopen(path, "r");
        if (file && fscanf(file, "%lu", &one) == 1) sum += one;
        if (file) fclose(file);
    }
    closedir(tasks);
    return sum;
}

static void say(Vehicle *v, uint64_t cmd_id) {
    uint8_t packet[ENQ_SIZE] = {ENQ};
    uint64_t n = v->step, barcode = 10 * (uint64_t)v->dev_id + 1;
    put(packet + 1, 4, v->dev_id);
    put(packet + 5, 8, cmd_id);
    put(packet + CODE_AT, 2, STATUS);
    if (!running) {
        put(packet + BODY_AT, 4, 0x01111110);
        put(packet + BODY_AT + 4, 4, 0xCF000000);
    } else if (way != 1) {
        put(packet + BODY_AT, 4, 0x08111110);
        put(packet + BODY_AT + 4, 4, 0xEF000000);
        barcode += n * 37 % 10000;
    } else {
        put(packet + BODY_AT, 4, 0x01111110 | (n & 7) << 12);
        put(packet + BODY_AT + 4, 4, 0xEB000000);
    }
    put(packet + BODY_AT + 8, 6, barcode);
    put(packet + BODY_AT + 14, 2, way == 0 ? n & 0xFFFF : 0);
    seal(packet, ENQ_SIZE);
    if (send(v->fd, packet, ENQ_SIZE, MSG_NOSIGNAL) != ENQ_SIZE) die("vehicles: send");
}

static void event(Vehicle *v) {
    v->step++;
    sent++;
    v->outstanding = ++cmd_ids;
    say(v, v->outstanding);
}

static void take_enq(Vehicle *v, const uint8_t *packet) {
    if (!sound(packet, ENQ_SIZE) || get(packet + CODE_AT, 2) != STATUS) {
        fprintf(stderr, "vehicles: asked for code %04x\n", (unsigned)get(packet + CODE_AT, 2));
        exit(1);
    }
    v->dev_id = (uint32_t)get(packet + 1, 4);
    asked += !v->up;
    v->up = 1;
    answers++;
    say(v, get(packet + 5, 8));
}

static void take_ack(Vehicle *v, const uint8_t *packet) {
    if (!sound(packet, ACK_SIZE)) {
        fprintf(stderr, "vehicles: an ACK with a wrong CRC\n");
        exit(1);
    }
    acked++;
    if (!rate && v->outstanding && get(packet + 5, 8) == v->outstanding) event(v);
}

static void received(Vehicle *v) {
    ssize_t size = recv(v->fd, v->in + v->held, sizeof v->in - (size_t)v->held, 0);
    if (size < 0 && errno == EAGAIN) return;
    if (size <= 0) {
        fprintf(stderr, "vehicles: the controller closed a connection\n");
        exit(1);
    }
    v->held += (int)size;
    int at = 0;
    while (at < v->held) {
        int need = v->in[at] == ACK ? ACK_SIZE : ENQ_SIZE;
        if (v->held - at < need) break;
        if (need == ACK_SIZE) take_ack(v, v->in + at);
        else take_enq(v, v->in + at);
        at += need;
    }
    v->held -= at;
    memmove(v->in, v->in + at, (size_t)v->held);
}

/* Send what has fallen due since the last look, of one vehicle after the other: neighbours in time are none in memory. */
static void due(int clock) {
    static uint64_t turn;
    uint64_t ticks;
    if (read(clock, &ticks, sizeof ticks) != sizeof ticks) return;
    while (ticks--) event(vehicles + turn++ * 7919 % (uint64_t)count);
}

static int paced(int epoll) {
    int clock = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK);
    struct itimerspec interval = {{0, 1000000000 / rate}, {0, 1000000000 / rate}};
    if (clock < 0 || timerfd_settime(clock, 0, &interval, NULL)) die("vehicles: timerfd");
    watch(epoll, clock, NULL);
    return clock;
}

static void serve(int epoll, int clock, double until, int enough) {
    struct epoll_event events[1024];
    while (seconds() < until && !(enough && asked >= enough)) {
        int ready = epoll_wait(epoll, events, 1024, 10);
        for (int i = 0; i < ready; i++) {
            if (events[i].data.ptr) received(events[i].data.ptr);
            else due(clock);
        }
    }
}

int main(int argc, char **argv) {
    if (argc != 8) return 2;
    crc_init();
    int pid = atoi(argv[2]), epoll = epoll_create1(0), clock = -1;
    count = atoi(argv[1]);
    way = atoi(argv[6]);
    rate = atoi(argv[7]);
    struct sockaddr_in address = loopback(0);
    socklen_t length = sizeof address;
    int listener = socket(AF_INET, SOCK_STREAM, 0);
    if (bind(listener, (struct sockaddr *)&address, length) || listen(listener, 4096)) die("vehicles: listen");
    getsockname(listener, (struct sockaddr *)&address, &length);
    printf("%d\n", ntohs(address.sin_port));
    fflush(stdout);
    if (!pid && scanf("%d", &pid) != 1) return 2;
    vehicles = calloc((size_t)count, sizeof *vehicles);
    for (int i = 0; i < count; i++) {
        vehicles[i].fd = accept(listener, NULL, NULL);
        if (vehicles[i].fd < 0) die("vehicles: accept");
        tune(vehicles[i].fd);
        watch(epoll, vehicles[i].fd, vehicles + i);
    }
    serve(epoll, clock, seconds() + 30, count);
    if (asked < count) {
        fprintf(stderr, "vehicles: %d of %d were asked for STATUS\n", asked, count);
        return 1;
    }
    serve(epoll, clock, seconds() + atof(argv[3]), 0);
    running = 1;
    if (rate) clock = paced(epoll);
    else if (way != 2)
        for (int i = 0; i < count; i++) event(vehicles + i);
    serve(epoll, clock, seconds() + atof(argv[4]), 0);
    uint64_t packets = acked, asks = answers, cpu = cpu_of(pid);
    double began = seconds();
    serve(epoll, clock, began + atof(argv[5]), 0);
    double took = seconds() - began;
    cpu = cpu_of(pid) - cpu;
    uint64_t done = acked - answers; /* an answer is acknowledged like an event */
    printf("{\"packets\": %lu, \"answers\": %lu, \"seconds\": %.3f, \"waiting\": %ld, \"cpu_us\": %.4f}\n", acked - packets, answers - asks,
           took, (long)(sent - done), (double)cpu / 1e3 / (double)(acked - packets));
    return 0;
}
